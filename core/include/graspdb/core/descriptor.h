// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graspdb {

// A HOG of 8 x 8 cells of 8 orientation bins; cells row by row, bins fastest. 255 stands for 1.
constexpr int kDescriptorSize = 512;
using Descriptor = std::array<std::uint8_t, kDescriptorSize>;

// A learned descriptor's code of a picture: a direction, with 128 for 0.
constexpr std::size_t kEmbeddingBlock = 64, kMostEmbeddingBytes = 128;
constexpr bool is_embedding_size(std::size_t bytes) {
  return bytes == kEmbeddingBlock || bytes == kMostEmbeddingBytes;
}
using Embedding = std::vector<std::uint8_t>;

// The bytes of either.
using DescriptorBytes = std::vector<std::uint8_t>;
using DescriptorView = std::span<const std::uint8_t>;

// Those of many rows, one behind the other.
struct DescriptorTable {
  DescriptorView bytes;
  std::size_t size = kDescriptorSize;  // of one: 64, 128 or 512

  std::size_t rows() const { return bytes.size() / size; }
  DescriptorView row(std::size_t row) const { return bytes.subspan(row * size, size); }
};

// Where a row's visible hand lies in its own picture, in tangents from the ray to the palm centre:
// what a camera one metre away would see, in metres.
struct BoxTangents {
  float x = 0;  // left edge
  float y = 0;  // upper edge
  float width = 0;
  float height = 0;
  bool operator==(const BoxTangents&) const = default;
};

}  // namespace graspdb
