// SPDX-License-Identifier: MIT
#include "picture_chunks.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace graspdb {
namespace {

// A number of `count` bytes; 0 beyond the end.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count,
                        bool little_endian) {
  if (at > bytes.size() || bytes.size() - at < count) return 0;
  std::string digits(bytes.substr(at, count));
  if (little_endian) std::reverse(digits.begin(), digits.end());
  std::uint32_t number = 0;
  for (const char digit : digits) number = number << 8 | static_cast<std::uint8_t>(digit);
  return number;
}

// EXIF is a TIFF: a byte order, then where the list of entries of 12 bytes lies.
int orientation_in(std::string_view exif) {
  constexpr std::string_view kPrefix("Exif\0\0", 6);  // of some programs' WebP
  if (exif.starts_with(kPrefix)) exif.remove_prefix(kPrefix.size());
  constexpr std::uint32_t kOrientation = 0x112;
  const bool little = exif.starts_with("II");
  const std::size_t list = number_at(exif, 4, 4, little);
  const std::size_t entries = number_at(exif, list, 2, little);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = list + 2 + 12 * i;
    if (number_at(exif, entry, 2, little) == kOrientation)
      return static_cast<int>(number_at(exif, entry + 8, 2, little));
  }
  return 1;
}

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

bool is_webp(std::string_view head) {
  return head.starts_with("RIFF") && head.ends_with("WEBP");
}

struct Chunk {
  std::string_view name;
  std::uint32_t length;  // of its data
  std::uint32_t rest;    // what lies between its data and the next chunk
};

// A PNG's chunk begins with its length and ends with a checksum; a WebP's begins with its name and
// is filled up to an even length.
Chunk chunk_at(std::string_view head, bool webp) {
  if (!webp) return {head.substr(4), number_at(head, 0, 4, false), 4};
  const std::uint32_t length = number_at(head, 4, 4, true);
  return {head.substr(0, 4), length, length % 2};
}

// Shows each chunk until `visit` says that it is enough. The file stands at the chunk's data.
template <typename Visit>
void visit_chunks(std::ifstream& file, bool webp, const Visit& visit) {
  file.seekg(webp ? 12 : 8);
  std::string head(8, '\0');
  while (file.read(head.data(), 8)) {
    const Chunk chunk = chunk_at(head, webp);
    const std::streamoff data = file.tellg();
    if (!visit(chunk)) return;
    file.seekg(data + static_cast<std::streamoff>(chunk.length) + chunk.rest);
  }
}

enum class Kind { kPng, kWebp, kOther };

Kind kind_of(std::ifstream& file) {
  std::string head(12, '\0');
  if (!file.read(head.data(), 12)) return Kind::kOther;
  return is_webp(head) ? Kind::kWebp : head.starts_with(kPngSignature) ? Kind::kPng : Kind::kOther;
}

}  // namespace

int orientation_in_chunk(const std::filesystem::path& path) {
  constexpr std::uint32_t kLongest = 1 << 16;  // cameras' are shorter
  std::ifstream file(path, std::ios::binary);
  const Kind kind = kind_of(file);
  int orientation = 1;
  if (kind == Kind::kOther) return orientation;
  visit_chunks(file, kind == Kind::kWebp, [&](const Chunk& chunk) {
    const bool is_exif = chunk.name == (kind == Kind::kWebp ? "EXIF" : "eXIf");
    if (!is_exif || chunk.length > kLongest) return true;
    std::string exif(chunk.length, '\0');
    if (file.read(exif.data(), chunk.length)) orientation = orientation_in(exif);
    return false;
  });
  return orientation;
}

bool is_png_with_a_chunk_beyond_its_end(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (kind_of(file) != Kind::kPng) return false;
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
  bool is_beyond = false;
  visit_chunks(file, false, [&](const Chunk& chunk) {
    is_beyond = static_cast<std::streamoff>(chunk.length) > size - file.tellg();
    return !is_beyond && chunk.name != "IEND";
  });
  return is_beyond;
}

}  // namespace graspdb
