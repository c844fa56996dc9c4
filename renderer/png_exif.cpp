// SPDX-License-Identifier: MIT
#include "png_exif.h"

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

}  // namespace

int png_orientation(const std::filesystem::path& path) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  constexpr std::uint32_t kLongest = 1 << 16;  // cameras' are shorter
  std::ifstream file(path, std::ios::binary);
  std::string head(8, '\0');
  if (!file.read(head.data(), 8) || head != kSignature) return 1;
  while (file.read(head.data(), 8)) {  // a chunk's length and name; its checksum follows it
    const std::uint32_t length = number_at(head, 0, 4, false);
    if (head.ends_with("eXIf") && length <= kLongest) {
      std::string exif(length, '\0');
      return file.read(exif.data(), length) ? orientation_in(exif) : 1;
    }
    file.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
  }
  return 1;
}

}  // namespace graspdb
