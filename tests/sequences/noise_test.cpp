// SPDX-License-Identifier: MIT
#include "graspdb/sequences/noise.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace graspdb {
namespace {

Mask square_mask() {
  Mask mask(200, 200);
  for (int y = 20; y < 180; ++y) std::fill_n(mask.row(y) + 20, 160, std::uint8_t{255});
  return mask;
}

std::ptrdiff_t area(const Mask& mask) {
  return std::count(mask.begin(), mask.end(), 255);
}

TEST(SegmentationNoise, AtAlphaZeroTheMaskStays) {
  EXPECT_EQ(add_segmentation_noise(square_mask(), 0, 1, 0), square_mask());
}

TEST(SegmentationNoise, IsAPureFunctionOfSeedAndFrame) {
  const Mask once = add_segmentation_noise(square_mask(), 1, 5, 3);
  EXPECT_EQ(once, add_segmentation_noise(square_mask(), 1, 5, 3));
  EXPECT_NE(once, add_segmentation_noise(square_mask(), 1, 5, 4));
  EXPECT_NE(once, add_segmentation_noise(square_mask(), 1, 6, 3));
}

// An inner pixel survives when some 7x7 block around it lost nothing: with p = 0.5 % that is
// likely, with 10 % almost never.
TEST(SegmentationNoise, MoreAlphaLeavesLess) {
  const auto whole = area(square_mask());
  const auto half_percent = area(add_segmentation_noise(square_mask(), 0.5, 1, 0));
  const auto two_percent = area(add_segmentation_noise(square_mask(), 2, 1, 0));
  EXPECT_LT(half_percent, whole);
  EXPECT_GT(half_percent, whole * 85 / 100);
  EXPECT_LT(two_percent, half_percent);
  EXPECT_LT(area(add_segmentation_noise(square_mask(), 30, 1, 0)), whole / 100);
}

TEST(SegmentationNoise, NeverAddsAPixel) {
  const Mask whole = square_mask(), noisy = add_segmentation_noise(whole, 1, 2, 0);
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_LE(noisy.data()[i], whole.data()[i]);
}

}  // namespace
}  // namespace graspdb
