// SPDX-License-Identifier: MIT
#include "gltf_buffers.h"

#include <algorithm>
#include <charconv>

#include "reduced_files.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

// The value of a digit of base 64, and of nothing else.
std::optional<unsigned> digit64(char c) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = kDigits.find(c);
  if (at == kDigits.npos) return std::nullopt;
  return static_cast<unsigned>(at);
}

std::string decoded64(std::string_view text, const JsonEntry& uri) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  unsigned bits = 0, known = 0;
  for (const char c : text) {
    const std::optional<unsigned> digit = digit64(c);
    if (!digit) uri.refuse("base 64", "another character");
    bits = (bits << 6 | *digit) & 0xFFFF, known += 6;
    if (known < 8) continue;
    known -= 8;
    bytes += static_cast<char>(bits >> known & 0xFF);
  }
  return bytes;
}

// "%20" is a blank.
std::string without_percent(std::string_view text, const JsonEntry& uri) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain += text[i];
      continue;
    }
    unsigned value = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto [end, fault] = std::from_chars(digits.begin(), digits.end(), value, 16);
    if (fault != std::errc() || end != digits.begin() + 2) {
      uri.refuse("two hexadecimal digits after each %", "others");
    }
    plain += static_cast<char>(value);
    i += 2;
  }
  return plain;
}

// Who opens a file that came from elsewhere gives it that folder, and no other.
fs::path path_below(const fs::path& folder, const JsonEntry& uri) {
  const std::string text = without_percent(uri.text(), uri);
  const fs::path path = text;
  const bool is_plain =
      std::ranges::none_of(text, [](unsigned char c) { return c < ' ' || c == ':' || c == '\\'; });
  if (!is_plain || text.empty() || path.is_absolute() || std::ranges::count(path, "..") > 0) {
    uri.refuse("a file in this folder or below it", text);
  }
  return folder / path;
}

}  // namespace

std::string GltfBuffers::read(const JsonEntry& uri) const {
  constexpr std::string_view kData = "data:", kBase64 = ";base64,";
  const std::string_view whole = uri.long_text();
  if (!whole.starts_with(kData)) return read_limited(path_below(folder_, uri));
  const std::size_t comma = whole.find(kBase64);
  if (comma == whole.npos) uri.refuse("data in base 64", "others");
  return decoded64(whole.substr(comma + kBase64.size()), uri);
}

std::string_view GltfBuffers::bytes(const JsonEntry& user) {
  const std::size_t index = user.whole(std::max<std::size_t>(all_.size(), binary_ ? 1 : 0));
  const bool has_uri = index < all_.size() && all_[index].has("uri");
  if (!has_uri && index == 0 && binary_) return *binary_;
  if (!has_uri) all_[index].refuse("a uri", "none");
  const auto known = read_.find(index);
  if (known != read_.end()) return known->second;
  return read_.emplace(index, read(all_[index].at("uri"))).first->second;
}

}  // namespace graspdb
