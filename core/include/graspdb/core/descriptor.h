// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace graspdb {

// A HOG of 8 x 8 cells of 8 orientation bins; cells row by row, bins fastest. 255 stands for 1.
constexpr int kDescriptorSize = 512;
using Descriptor = std::array<std::uint8_t, kDescriptorSize>;

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
