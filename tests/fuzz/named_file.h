// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "memory_file.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {

// This process's own folder.
inline const std::filesystem::path& own_folder() {
  static const TemporaryDirectory folder;
  return folder.path();
}

// A file in that folder, for readers that go by the name or by what lies beside it. It lives in
// memory all the same: the name is a link. Writing it again costs no disk either.
inline std::filesystem::path named_file(const std::string& name, std::string_view bytes) {
  static std::map<std::string, std::unique_ptr<MemoryFile>> files;
  const std::filesystem::path path = own_folder() / name;
  std::unique_ptr<MemoryFile>& file = files[name];
  if (file == nullptr) {
    file = std::make_unique<MemoryFile>(bytes);
    std::filesystem::create_symlink(file->path(), path);
  } else {
    file->fill(bytes);
  }
  return path;
}

}  // namespace graspdb::testing
