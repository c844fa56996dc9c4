// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "graspdb/core/image.h"
#include "graspdb/core/random.h"

namespace graspdb::testing {

inline int area(const Mask& mask) {
  return static_cast<int>(std::count(mask.begin(), mask.end(), 255));
}

struct Picture {
  GrayImage gray;
  Mask mask;
};

// Smooth shading, noise of some grey levels, flat stretches and a ragged mask in a box of this
// size, which lies `border` pixels inside the picture.
inline Picture random_picture(std::uint64_t seed, int box_width, int box_height, int border) {
  RandomStream random(seed);
  const int width = box_width + 2 * border, height = box_height + 2 * border;
  Picture picture{GrayImage(width, height), Mask(width, height)};
  const double slope_x = random.uniform(-2, 2), slope_y = random.uniform(-2, 2);
  const auto levels = static_cast<std::uint64_t>(1 + seed % 6);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double ramp = 128 + slope_x * (x - width / 2) + slope_y * (y - height / 2);
      const double noisy = ramp + static_cast<double>(random.below(levels));
      const bool flat = (x / 11 + y / 7) % 3 == 0;
      picture.gray.at(x, y) = flat ? 90 : static_cast<std::uint8_t>(std::clamp(noisy, 0.0, 255.0));
    }
  }
  for (int y = 0; y < box_height; ++y) {
    for (int x = 0; x < box_width; ++x) {
      const bool corner = (x == 0 && y == 0) || (x == box_width - 1 && y == box_height - 1);
      const bool hole = (x / 9 + y / 5) % 4 == 0 || random.below(40) == 0;
      picture.mask.at(border + x, border + y) = corner || !hole ? 255 : 0;
    }
  }
  return picture;
}

}  // namespace graspdb::testing
