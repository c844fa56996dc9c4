// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <filesystem>
#include <string>

#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"

namespace graspdb::testing {

// A database file taken apart, so that a test can alter the header and still have its checksum
// right: what an attacker or a faulty writer would make. Written from docs/format.md alone.
struct FileParts {
  std::string header;
  std::string data;
};

inline FileParts take_apart(const std::string& bytes) {
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), 8);
  return {bytes.substr(8, length), bytes.substr(8 + length)};
}

inline std::string put_together(const FileParts& parts) {
  const std::uint64_t length = parts.header.size();
  return std::string(reinterpret_cast<const char*>(&length), 8) + parts.header + parts.data;
}

// Pads the header to 64 bytes again and makes its checksum true again.
inline std::string sealed(FileParts parts) {
  parts.header.erase(parts.header.find_last_not_of(' ') + 1);
  while ((8 + parts.header.size()) % 64 != 0) parts.header += ' ';
  const std::string key = R"("header_hash":")";
  const std::size_t at = parts.header.find(key);
  if (at != std::string::npos && at + key.size() + 32 <= parts.header.size()) {
    parts.header.replace(at + key.size(), 32, 32, '0');
    parts.header.replace(at + key.size(), 32, hash_hex(parts.header));
  }
  return put_together(parts);
}

}  // namespace graspdb::testing
