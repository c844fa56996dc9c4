// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace graspdb {

// A whole file, mapped read-only. Its bytes live as long as it does; a file that someone shortens
// meanwhile kills the reader, which is why files are replaced by renaming and never in place.
class MappedFile {
 public:
  // Throws Error when the file cannot be read. An empty file is empty bytes.
  explicit MappedFile(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace graspdb
