// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graspdb {

// A picture that owns its pixels, row by row without padding. Integer coordinates are pixel
// centres.
template <typename T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, T value = T{})
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  std::size_t size() const { return pixels_.size(); }

  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }
  T* row(int y) { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_; }
  const T* row(int y) const { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * width_; }
  T* data() { return pixels_.data(); }
  const T* data() const { return pixels_.data(); }
  auto begin() { return pixels_.begin(); }
  auto end() { return pixels_.end(); }
  auto begin() const { return pixels_.begin(); }
  auto end() const { return pixels_.end(); }

  bool operator==(const Image&) const = default;

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<T> pixels_;
};

using GrayImage = Image<std::uint8_t>;
using Mask = Image<std::uint8_t>;         // 0 outside, 255 inside
using Bgr = std::array<std::uint8_t, 3>;  // OpenCV's order
using ColorImage = Image<Bgr>;

// Left and right exchanged.
template <typename T>
Image<T> mirrored(Image<T> image) {
  for (int y = 0; y < image.height(); ++y) std::reverse(image.row(y), image.row(y) + image.width());
  return image;
}

// An axis-aligned box of whole pixels: x <= column < x + width.
struct Box {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool operator==(const Box&) const = default;
};

}  // namespace graspdb
