// SPDX-License-Identifier: MIT
// Layers of a net in whole numbers: the same result with every instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graspdb {

// Output channels are worked on in blocks, inputs in fours: numbers of channels are rounded up to
// these, with weights of 0.
constexpr std::size_t kOutputBlock = 16;
constexpr std::size_t kInputQuad = 4;

// A square convolution over a square picture whose channels are the fastest index. A linear layer
// is one whose kernel is as large as the picture.
struct Convolution {
  std::size_t inputs = 0, outputs = 0;  // channels, rounded up
  std::size_t kernel = 1, stride = 1, padding = 0;
  std::size_t side = 0;                        // of the picture that comes in, without padding
  std::vector<std::int8_t> weights;            // [outputs / 16][kernel][kernel * inputs / 4][16][4]
  std::vector<std::int32_t> bias, multiplier;  // one an output; multipliers are not negative

  std::size_t padded_side() const { return side + 2 * padding; }
  std::size_t out_side() const { return (padded_side() - kernel) / stride + 1; }
};

// Row `y` of the result: for each pixel and output (the sum of products + bias) * multiplier /
// 2^32, rounded, a half upwards. `picture` has padded_side() x padded_side() pixels, `row`
// out_side(). The sums must stay below 2^31.
void convolve_row(const Convolution& layer, std::span<const std::uint8_t> picture, std::size_t y,
                  std::span<std::int32_t> row);

}  // namespace graspdb
