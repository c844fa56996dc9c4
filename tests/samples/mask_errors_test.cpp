// SPDX-License-Identifier: MIT
#include "mask_errors.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace graspdb {
namespace {

// A palm with an arm to the right: 100 columns of hand, 60 of arm.
Mask hand_with_arm() {
  Mask mask(200, 200);
  for (int y = 50; y < 150; ++y) std::fill(mask.row(y) + 10, mask.row(y) + 110, 255);
  for (int y = 75; y < 125; ++y) std::fill(mask.row(y) + 110, mask.row(y) + 170, 255);
  return mask;
}

constexpr double kPxPerMm = 1;
const ArmInPicture kArm{{110, 100}, {1, 0}, kPxPerMm, kPxPerMm};

// Nothing but what is asked for.
SampleConfig without_errors() {
  return {.wrist_cut_mm = 0, .noise_percent = 0, .torn = 0, .outline_px = 0};
}

int area(const Mask& mask) {
  return static_cast<int>(
      std::ranges::count_if(mask, [](std::uint8_t pixel) { return pixel != 0; }));
}

Mask found(const SampleConfig& config, std::uint64_t draw) {
  RandomStream random(7, draw);
  return found_mask(hand_with_arm(), kArm, config, random);
}

// The column behind the last one of the mask.
int right_end(const Mask& mask) {
  int end = 0;
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = end; x < mask.width(); ++x) {
      if (mask.at(x, y) != 0) end = x + 1;
    }
  }
  return end;
}

TEST(FoundMask, WithoutErrorsIsTheMask) {
  const int wrong = area(hand_with_arm()) / 200;  // corners that smoothing takes off
  EXPECT_NEAR(area(found(without_errors(), 0)), area(hand_with_arm()), wrong);
}

TEST(FoundMask, TheArmEndsAsFarOffAsIsAskedFor) {
  SampleConfig config = without_errors();
  config.wrist_cut_mm = 30;
  int nearest = 1000, furthest = 0, whole = 0;
  for (std::uint64_t draw = 0; draw < 200; ++draw) {
    const int end = right_end(found(config, draw));
    if (end == 170) {
      ++whole;
      continue;
    }
    nearest = std::min(nearest, end);
    furthest = std::max(furthest, end);
  }
  // 15 mm behind the wrist and up to 30 mm to either side; three in ten are not cut.
  EXPECT_GE(nearest, 110 + 15 - 30 - 2);
  EXPECT_LE(nearest, 110 + 15 - 15);
  EXPECT_GE(furthest, 110 + 15 + 15);
  EXPECT_LE(furthest, 110 + 15 + 30 + 2);
  EXPECT_NEAR(whole, 60, 25);
}

TEST(FoundMask, WithoutAnArmNothingIsCut) {
  SampleConfig config = without_errors();
  config.wrist_cut_mm = 30;
  for (std::uint64_t draw = 0; draw < 20; ++draw) {
    RandomStream random(7, draw);
    EXPECT_EQ(right_end(found_mask(hand_with_arm(), std::nullopt, config, random)), 170);
  }
}

TEST(FoundMask, OutlinesAreThinnerAndFatter) {
  SampleConfig config = without_errors();
  config.outline_px = 3;
  int least = area(hand_with_arm()), most = least;
  const int plain = least;
  for (std::uint64_t draw = 0; draw < 30; ++draw) {
    least = std::min(least, area(found(config, draw)));
    most = std::max(most, area(found(config, draw)));
  }
  EXPECT_LT(least, 0.92 * plain);
  EXPECT_GT(most, 1.05 * plain);
}

TEST(FoundMask, NoiseAndTearsChangeSomeMasks) {
  for (const bool noise : {false, true}) {
    SampleConfig config = without_errors();
    (noise ? config.noise_percent : config.torn) = noise ? 10 : 1;
    int changed = 0;
    for (std::uint64_t draw = 0; draw < 30; ++draw) {
      changed += found(config, draw) != found(without_errors(), draw);
    }
    EXPECT_GE(changed, 5);
  }
}

TEST(DrawOutline, IsOfTheSizeThatIsAskedFor) {
  for (const Outline outline : {Outline::kEllipse, Outline::kRectangle}) {
    for (std::uint64_t draw = 0; draw < 50; ++draw) {
      RandomStream random(3, draw);
      const Mask mask = draw_outline(100, 100, outline, 0.1, 0.2, random);
      EXPECT_GT(area(mask), 0);
      EXPECT_LE(area(mask), 45 * 45);  // twice 20 and a pixel, and what lines round up to
    }
  }
}

}  // namespace
}  // namespace graspdb
