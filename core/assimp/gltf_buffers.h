// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json_entry.h"

namespace graspdb {

// The bytes of a glTF file's buffers: the binary chunk of a .glb, what a "data:" URI holds, or a
// file in the same folder or one below it. Each is read when it is first used.
class GltfBuffers {
 public:
  // `binary` is a .glb's chunk, and nothing for a .gltf.
  GltfBuffers(const JsonEntry& root, std::filesystem::path folder,
              std::optional<std::string_view> binary)
      : all_(root.items("buffers")), folder_(std::move(folder)), binary_(binary) {}

  // Of the buffer that `user` is the index of; they last as long as this.
  std::string_view bytes(const JsonEntry& user);

 private:
  std::string read(const JsonEntry& uri) const;

  std::vector<JsonEntry> all_;
  std::filesystem::path folder_;
  std::optional<std::string_view> binary_;
  std::map<std::size_t, std::string> read_;
};

}  // namespace graspdb
