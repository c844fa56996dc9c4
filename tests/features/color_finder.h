// SPDX-License-Identifier: MIT
// A learned finder that goes by plain colours.
#pragma once

#include <algorithm>

#include "features/net_bytes.h"
#include "graspdb/features/hand_finder.h"

namespace graspdb::testing {

// Red is hand, green arm, blue object, and black the rest: a score is a colour.
inline HandFinder color_finder() {
  constexpr std::int8_t kOne = 64;
  NetLayer layer{4,
                 1,
                 3,
                 1,
                 0,
                 std::vector<std::int8_t>(12),
                 {64 * 100, 0, 0, 0},
                 std::vector<std::int32_t>(4, 1 << 26),
                 {}};
  layer.weights[3 * 1 + 2] = layer.weights[3 * 2 + 1] = layer.weights[3 * 3 + 0] = kOne;
  return HandFinder::parse(finder_file({layer}).bytes(), "net");
}

inline constexpr Bgr kRed = {0, 0, 200}, kGreen = {0, 200, 0}, kBlue = {200, 0, 0};

inline void paint(ColorImage& frame, const Box& box, const Bgr& color) {
  for (int y = box.y; y < box.y + box.height; ++y)
    std::fill_n(frame.row(y) + box.x, box.width, color);
}

}  // namespace graspdb::testing
