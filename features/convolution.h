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

// Bytes of a picture whose channels are the fastest index, with a frame of zeros around it.
struct PaddedPicture {
  PaddedPicture(std::size_t width_px, std::size_t height_px, std::size_t channel_count,
                std::size_t padding_px)
      : width(width_px), height(height_px), channels(channel_count), padding(padding_px) {
    bytes.resize(line() * (height + 2 * padding));
  }

  std::size_t line() const { return (width + 2 * padding) * channels; }
  // The channels of the first pixel of a row, counted without the frame.
  std::uint8_t* row(std::size_t y) { return bytes.data() + begin(y); }
  const std::uint8_t* row(std::size_t y) const { return bytes.data() + begin(y); }

  std::size_t width, height, channels, padding;
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t begin(std::size_t y) const { return (y + padding) * line() + padding * channels; }
};

// A convolution with a square kernel. A linear layer is one whose kernel is as large as the
// picture.
struct Convolution {
  std::size_t inputs = 0, outputs = 0;  // channels, rounded up
  std::size_t kernel = 1, stride = 1, padding = 0;
  std::vector<std::int8_t> weights;            // [outputs / 16][kernel][kernel * inputs / 4][16][4]
  std::vector<std::int32_t> bias, multiplier;  // one an output; multipliers are not negative

  // Of a picture's width or height, which is such that the kernel fits into the padded picture.
  std::size_t out_size(std::size_t size) const {
    return (size + 2 * padding - kernel) / stride + 1;
  }
};

// Row `y` of the result: for each pixel and output (the sum of products + bias) * multiplier /
// 2^32, rounded, a half upwards. `picture` has the layer's inputs and padding, `row`
// out_size(width) * outputs numbers. The sums must stay below 2^31.
void convolve_row(const Convolution& layer, const PaddedPicture& picture, std::size_t y,
                  std::span<std::int32_t> row);

// All rows, each number cut to a byte, with a frame for the layer that reads them.
PaddedPicture convolve(const Convolution& layer, const PaddedPicture& picture,
                       std::size_t next_padding);

}  // namespace graspdb
