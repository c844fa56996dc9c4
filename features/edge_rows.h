// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace graspdb {

constexpr std::size_t kEdgeSide = 64;
// The picture has a frame of one pixel, so that all of its pixels have eight neighbours.
constexpr std::size_t kEdgeStride = kEdgeSide + 2;
using EdgeCanvas = std::array<float, kEdgeStride * kEdgeStride>;

constexpr std::size_t edge_index(std::size_t x, std::size_t y) {
  return (y + 1) * kEdgeStride + x + 1;
}

// What the pixels of a row vote for: directions modulo 180 degrees, counted in bins of 22.5, 0..8,
// a bin's centre being a whole number, so that upright and level outlines do not lie between two;
// and how much. A direction is not a number where there is no edge and no weight.
struct EdgeRow {
  using Values = std::array<float, kEdgeSide>;
  Values outline_bin, outline_weight;  // of the coverage
  Values inner_bin, inner_weight;      // of the brightness, where all neighbours are mostly covered
};

// Sobel's gradients of one row, a pixel being the unit of length. The same bytes with every
// instruction set.
void find_edges(const EdgeCanvas& coverage, const EdgeCanvas& brightness, std::size_t y,
                EdgeRow& edges);

}  // namespace graspdb
