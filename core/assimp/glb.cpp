// SPDX-License-Identifier: MIT
#include "graspdb/core/assimp/glb.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::string_view kMagic = "glTF", kJson = "JSON", kBinary = {"BIN\0", 4};

std::size_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

std::string_view chunk(std::string_view bytes, std::string_view type, const std::string& file) {
  const std::string key = type == kJson ? "JSON chunk" : "BIN chunk";
  if (bytes.size() < kChunkHeader || bytes.substr(4, 4) != type) {
    throw Error({file, key, "its header", "something else"});
  }
  const std::size_t room = bytes.size() - kChunkHeader, length = word(bytes, 0);
  if (length > room) {
    throw Error({file, key, fmt::format("at most {} bytes", room), fmt::format("{}", length)});
  }
  return bytes.substr(kChunkHeader, length);
}

}  // namespace

GlbParts glb_parts(std::string_view bytes, const std::string& file) {
  if (bytes.size() < kHeader || !bytes.starts_with(kMagic) || word(bytes, 4) != 2) {
    throw Error({file, "", "a .glb of version 2", "something else"});
  }
  if (word(bytes, 8) != bytes.size()) {
    throw Error({file, "length", fmt::format("that of the file, {}", bytes.size()),
                 fmt::format("{}", word(bytes, 8))});
  }
  GlbParts parts;
  parts.json = chunk(bytes.substr(kHeader), kJson, file);
  const std::size_t end = kHeader + kChunkHeader + parts.json.size();
  if (end < bytes.size()) parts.binary = chunk(bytes.substr(end), kBinary, file);
  return parts;
}

std::string glb_file(std::string json, std::string_view binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string file(kMagic);
  const auto word = [&](std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    file.append(reinterpret_cast<const char*>(&bits), 4);
  };
  word(2);
  word(kHeader + 2 * kChunkHeader + json.size() + binary.size());
  word(json.size());
  file.append(kJson).append(json);
  word(binary.size());
  return file.append(kBinary).append(binary);
}

}  // namespace graspdb
