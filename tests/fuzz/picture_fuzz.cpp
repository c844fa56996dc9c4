// SPDX-License-Identifier: MIT
// Whatever follows the signature of a PNG: the same picture comes twice, or an Error refuses it.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "graspdb/core/error.h"
#include "graspdb/renderer/image_io.h"
#include "memory_file.h"
#include "named_file.h"

namespace graspdb {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";

// As the PNG specification has it, bit by bit.
std::uint32_t crc(std::string_view bytes) {
  std::uint32_t sum = ~0U;
  for (const char byte : bytes) {
    sum ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xEDB88320U : 0);
  }
  return ~sum;
}

std::uint32_t big_endian(std::uint32_t value) {
  return __builtin_bswap32(value);
}

// Nearly every altered file fails at a checksum; with true ones the decoder behind sees it.
void make_checksums_true(std::string& png) {
  for (std::size_t at = kSignature.size(); at + 12 <= png.size();) {
    std::uint32_t length = 0;
    std::memcpy(&length, png.data() + at, sizeof(length));
    length = big_endian(length);
    if (length > png.size() - at - 12) return;
    const std::uint32_t sum = big_endian(crc(std::string_view(png).substr(at + 4, length + 4)));
    std::memcpy(png.data() + at + 8 + length, &sum, sizeof(sum));
    at += 12 + length;
  }
}

void expect_picture_or_refused(const std::filesystem::path& file) {
  try {
    const ColorImage color = read_color(file);
    if (color.empty() || read_gray(file).size() != color.size()) std::abort();
    if (read_levels(file).gray.size() != color.size()) std::abort();
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string png(graspdb::testing::text_of(data, size));
  if (!png.starts_with(graspdb::kSignature)) return 0;
  graspdb::make_checksums_true(png);
  graspdb::expect_picture_or_refused(graspdb::testing::named_file("picture.png", png));
  return 0;
}
