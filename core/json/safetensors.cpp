// SPDX-License-Identifier: MIT
#include "graspdb/core/json/safetensors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/json/strict_json.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "tensors are read as they lie");

constexpr std::size_t kLengthBytes = 8;
constexpr std::size_t kAlignment = 8;
constexpr const char* kMetadata = "__metadata__";
constexpr std::size_t kLongestSide = std::size_t{1} << 31;

std::size_t count_of(const TensorInfo& info) {
  std::size_t count = 1;
  for (const std::size_t length : info.shape) count *= length;
  return count;
}

std::string described(const TensorInfo& info) {
  return fmt::format("{} [{}]", info.dtype, fmt::join(info.shape, ", "));
}

std::vector<std::size_t> sizes(const JsonFields& entry, const std::string& name,
                               const std::string& file) {
  std::vector<std::size_t> numbers;
  const json& list = entry.at(name);
  if (!list.is_array()) throw Error({file, name, "a list", list.dump()});
  for (const json& number : list) {
    if (!number.is_number_unsigned() || number.get<std::uint64_t>() > kLongestSide) {
      throw Error({file, name, "whole numbers below 2^31", number.dump()});
    }
    numbers.push_back(number.get<std::size_t>());
  }
  return numbers;
}

// As many bytes as the file has for it, or an Error: a product of lengths may overflow.
void check_bytes(const TensorInfo& info, std::size_t bytes, const std::string& file) {
  std::size_t left = bytes / std::max(dtype_bytes(info.dtype), std::size_t{1});
  for (const std::size_t length : info.shape) {
    if (length == 0 || left % length != 0) left = 0;
    if (left > 0) left /= length;
  }
  if (left == 1 && count_of(info) * dtype_bytes(info.dtype) == bytes) return;
  throw Error(
      {file, info.name, described(info) + " of a known type", fmt::format("{} bytes", bytes)});
}

std::string_view header_text(const std::string& bytes, const std::string& file) {
  std::uint64_t length = 0;
  if (bytes.size() >= kLengthBytes) std::memcpy(&length, bytes.data(), kLengthBytes);
  if (length == 0 || length > bytes.size() - kLengthBytes) {
    throw Error({file, "header", "a safetensors file",
                 fmt::format("a header of {} bytes in a file of {}", length, bytes.size())});
  }
  return {bytes.data() + kLengthBytes, length};
}

}  // namespace

std::size_t dtype_bytes(const std::string& dtype) {
  if (dtype == "U8" || dtype == "I8") return 1;
  return dtype == "I32" || dtype == "F32" ? 4 : 0;
}

std::string safetensors_header(std::span<const TensorInfo> tensors,
                               const std::map<std::string, std::string>& metadata) {
  ordered_json root{{kMetadata, metadata}};
  std::size_t offset = 0;
  for (const TensorInfo& tensor : tensors) {
    const std::size_t end = offset + count_of(tensor) * dtype_bytes(tensor.dtype);
    root[tensor.name] = {
        {"dtype", tensor.dtype}, {"shape", tensor.shape}, {"data_offsets", {offset, end}}};
    offset = end;
  }
  std::string text = root.dump();
  text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, ' ');
  const std::uint64_t length = text.size();
  return std::string(reinterpret_cast<const char*>(&length), kLengthBytes) + text;
}

Safetensors Safetensors::load(const fs::path& file, std::size_t most_bytes) {
  std::error_code unknown;  // read_text() reports what matters
  const std::uintmax_t size = fs::file_size(file, unknown);
  if (!unknown && size > most_bytes) {
    throw Error({.file = file.string(),
                 .expected = fmt::format("at most {} bytes", most_bytes),
                 .found = fmt::format("{}", size)});
  }
  return parse(read_text(file), file.string());
}

Safetensors Safetensors::parse(std::string bytes, const std::string& file) {
  Safetensors result;
  result.file_ = file;
  result.bytes_ = std::move(bytes);
  const std::string_view text = header_text(result.bytes_, file);
  const std::size_t start = kLengthBytes + text.size(), size = result.bytes_.size() - start;
  const json root = parse_strict_json(text, file, "header");
  std::map<std::size_t, std::size_t> parts;  // where each begins and ends
  for (const auto& [name, value] : JsonFields(root, file, "header").items()) {
    if (name == kMetadata) continue;
    const JsonFields entry(value, file, name);
    const TensorInfo info{name, entry.text("dtype"), sizes(entry, "shape", file)};
    const auto offsets = sizes(entry, "data_offsets", file);
    if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] > size) {
      throw Error(
          {file, name + ".data_offsets", "a part of the file", entry.at("data_offsets").dump()});
    }
    check_bytes(info, offsets[1] - offsets[0], file);
    parts[offsets[0]] = offsets[1];
    result.tensors_[name] = {info, start + offsets[0], start + offsets[1]};
  }
  std::size_t end = 0;
  for (const auto& [begin, next] : parts) {
    if (begin != end) break;
    end = next;
  }
  if (end != size || parts.size() != result.tensors_.size()) {
    throw Error({file, "header", "tensors that fill the file, none twice", "others"});
  }
  if (!root.contains(kMetadata)) return result;
  const JsonFields metadata(root[kMetadata], file, kMetadata);
  for (const auto& [key, value] : metadata.items()) result.metadata_[key] = metadata.text(key);
  return result;
}

const std::string& Safetensors::metadata(const std::string& key) const {
  const auto found = metadata_.find(key);
  if (found == metadata_.end()) throw Error({file_, key, "an entry of __metadata__", "none"});
  return found->second;
}

const Safetensors::Place& Safetensors::place(const std::string& name) const {
  const auto found = tensors_.find(name);
  if (found == tensors_.end()) throw Error({file_, name, "a tensor", "none"});
  return found->second;
}

const std::vector<std::size_t>& Safetensors::shape(const std::string& name) const {
  return place(name).info.shape;
}

std::span<const char> Safetensors::bytes_of(const TensorInfo& expected) const {
  const Place& found = place(expected.name);
  const bool fits =
      std::ranges::equal(expected.shape, found.info.shape,
                         [](std::size_t a, std::size_t b) { return a == 0 || a == b; });
  if (!fits || expected.dtype != found.info.dtype) {
    throw Error({file_, expected.name, described(expected), described(found.info)});
  }
  return {bytes_.data() + found.begin, found.end - found.begin};
}

}  // namespace graspdb
