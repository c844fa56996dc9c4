// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "features/pictures.h"
#include "graspdb/core/random.h"
#include "graspdb/features/hand_finder.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {
namespace {

using testing::area;

constexpr int kWidth = 320, kHeight = 240;
constexpr Bgr kSkin = {100, 130, 190};
constexpr Bgr kWall = {120, 120, 120};

// A palm with an arm that leaves the picture at its lower border.
Mask palm_and_arm() {
  Mask mask(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool palm = std::hypot(x - 160, y - 90) < 45;
      const bool arm = std::abs(x - 160) < 22 && y > 90;
      if (palm || arm) mask.at(x, y) = 255;
    }
  }
  return mask;
}

// Lit from the left, as a hand is: half as bright on its right.
ColorImage painted(const Mask& mask, const Bgr& color) {
  ColorImage frame(kWidth, kHeight, kWall);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (mask.at(x, y) == 0) continue;
      const double light = std::clamp(1 - (x - 110) / 200.0, 0.5, 1.0);
      for (std::size_t c = 0; c < 3; ++c) {
        frame.at(x, y)[c] = static_cast<std::uint8_t>(light * color[c]);
      }
    }
  }
  return frame;
}

TEST(IsolateHand, KeepsThePalmAndDropsTheArm) {
  const Mask hand = isolate_hand(palm_and_arm());
  EXPECT_EQ(hand.at(160, 90), 255);
  EXPECT_EQ(hand.at(160, kHeight - 5), 0);
}

TEST(IsolateHand, WhatIsCutOffIsTheArm) {
  const Mask whole = palm_and_arm();
  const FoundHand found = split_hand(whole);
  EXPECT_EQ(found.hand, isolate_hand(whole));
  EXPECT_GT(area(found.arm), 2000);
  for (std::size_t i = 0; i < whole.size(); ++i)
    EXPECT_FALSE(found.hand.data()[i] != 0 && found.arm.data()[i] != 0);
  const auto direction = arm_direction(found);
  ASSERT_TRUE(direction);
  EXPECT_NEAR(direction->x(), 0, 0.05);
  EXPECT_NEAR(direction->y(), 1, 0.01);
}

TEST(IsolateHand, AHandWithoutAnArmHasNoDirectionOfIt) {
  const Mask hand = isolate_hand(palm_and_arm()), nothing(kWidth, kHeight);
  EXPECT_FALSE(arm_direction({hand, nothing}));
  EXPECT_FALSE(arm_direction({nothing, hand}));
  Mask speck = nothing;
  speck.at(3, 3) = 255;
  EXPECT_FALSE(arm_direction({hand, speck}));
}

TEST(IsolateHand, FillsPinholesAndTakesFrayedEdgesAway) {
  const Mask whole = palm_and_arm();
  Mask frayed = whole;
  RandomStream random(1);
  for (std::uint8_t& pixel : frayed) pixel = random.uniform() < 0.05 ? 0 : pixel;
  const Mask hand = isolate_hand(frayed), wanted = isolate_hand(whole);
  std::ptrdiff_t different = 0;
  for (std::size_t i = 0; i < hand.size(); ++i) different += hand.data()[i] != wanted.data()[i];
  EXPECT_LT(different, area(wanted) / 30);
}

TEST(IsolateHand, AHoleAsLargeAsAnObjectStays) {
  Mask mask = palm_and_arm();
  for (int y = 80; y < 100; ++y) std::fill_n(mask.row(y) + 150, 20, std::uint8_t{0});
  EXPECT_EQ(isolate_hand(mask).at(160, 90), 0);
}

// The palm and arm with a bar across the palm, as an object before it, and a patch of skin.
Mask cut_in_two(const Box& patch) {
  Mask mask = palm_and_arm();
  for (int y = 60; y < 80; ++y) std::fill_n(mask.row(y), kWidth, std::uint8_t{0});
  for (int y = patch.y; y < patch.y + patch.height; ++y)
    std::fill_n(mask.row(y) + patch.x, patch.width, std::uint8_t{255});
  return mask;
}

TEST(IsolateHand, AllPiecesThatAnObjectLeavesAreKept) {
  const Mask hand = isolate_hand(cut_in_two({}));
  EXPECT_EQ(hand.at(160, 52), 255);
  EXPECT_EQ(hand.at(160, 70), 0);
  EXPECT_EQ(hand.at(160, 95), 255);
  EXPECT_EQ(hand.at(160, kHeight - 5), 0);  // the arm
}

TEST(IsolateHand, PiecesAroundALargeObjectAreKept) {
  EXPECT_EQ(isolate_hand(cut_in_two({270, 40, 20, 20})).at(280, 50), 255);
}

TEST(IsolateHand, WhatComesInFromTheBorderIsNoPiece) {
  const Mask hand = isolate_hand(cut_in_two({270, 0, 20, 60}));
  EXPECT_EQ(hand.at(280, 50), 0);
  EXPECT_EQ(hand.at(160, 52), 255);
  const Mask beside_a_corner = isolate_hand(cut_in_two({0, 0, 30, 30}));
  EXPECT_EQ(beside_a_corner.at(15, 15), 0);
  EXPECT_EQ(beside_a_corner.at(160, 52), 255);
}

TEST(IsolateHand, SpecksAndSkinFarAwayAreNoPieces) {
  EXPECT_EQ(isolate_hand(cut_in_two({230, 90, 4, 4})).at(231, 91), 0);
  Mask wide(4 * kWidth, kHeight);
  const Mask near = cut_in_two({});
  for (int y = 0; y < kHeight; ++y) std::copy_n(near.row(y), kWidth, wide.row(y));
  for (int y = 80; y < 120; ++y) std::fill_n(wide.row(y) + 3 * kWidth, 40, std::uint8_t{255});
  EXPECT_EQ(isolate_hand(wide).at(3 * kWidth + 20, 100), 0);
  EXPECT_EQ(isolate_hand(wide).at(160, 52), 255);
}

TEST(IsolateHand, WhatFillsThePicturesBorderIsNoHand) {
  EXPECT_EQ(area(isolate_hand(Mask(kWidth, kHeight, 255))), 0);
}

TEST(IsolateHand, AnEndlessOutlineIsNoHand) {
  Mask comb(kWidth, kHeight);
  for (int y = 40; y < 200; ++y) {
    for (int x = 40; x < 280; ++x) comb.at(x, y) = x % 6 < 3 || y < 50 ? 255 : 0;
  }
  EXPECT_EQ(area(isolate_hand(comb)), 0);
}

// Every pixel as a square of them.
template <typename Pixel>
Image<Pixel> magnified(const Image<Pixel>& image, int factor) {
  Image<Pixel> large(factor * image.width(), factor * image.height());
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) large.at(x, y) = image.at(x / factor, y / factor);
  }
  return large;
}

std::ptrdiff_t differing(const Mask& one, const Mask& other) {
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < one.size(); ++i) count += one.data()[i] != other.data()[i];
  return count;
}

TEST(FindByColor, OfALargeFrameIsWhatIsFoundInFewerPixels) {
  const ColorImage frame = painted(palm_and_arm(), kSkin);
  const FoundHand wanted = find_by_color(frame);
  ASSERT_EQ(wanted.hand, isolate_hand(palm_and_arm()));
  for (int factor = 2; factor < 5; ++factor) {
    const FoundHand found = find_by_color(magnified(frame, factor));
    EXPECT_LT(differing(found.hand, magnified(wanted.hand, factor)), area(found.hand) / 50);
    EXPECT_LT(differing(found.arm, magnified(wanted.arm, factor)), area(found.arm) / 50);
    Mask both = found.hand;
    std::ranges::transform(both, found.arm, both.begin(), std::bit_or());
    EXPECT_EQ(area(both), area(found.hand) + area(found.arm));
  }
}

TEST(FindByColor, RoiAndLeastAreaAreInTheFramesPixels) {
  const ColorImage frame = magnified(painted(palm_and_arm(), kSkin), 3);
  const auto finds = [&](const std::optional<Box>& roi, const SkinOptions& options = {}) {
    return !is_empty(find_by_color(frame, roi, options).hand);
  };
  EXPECT_TRUE(finds(Box{340, 265, 10, 10}));  // the palm begins at x = 348
  EXPECT_FALSE(finds(Box{335, 265, 10, 10}));
  const auto skin = static_cast<int>(9 * area(palm_and_arm()));
  EXPECT_TRUE(finds({}, {.min_area_px = skin * 9 / 10}));
  EXPECT_FALSE(finds({}, {.min_area_px = skin * 11 / 10}));
}

TEST(FindHand, SkinBeforeAWallIsFound) {
  const Mask hand = find_hand(painted(palm_and_arm(), kSkin)).hand;
  EXPECT_EQ(hand.at(160, 90), 255);
  EXPECT_GT(area(hand), 5000);
}

TEST(FindHand, APatchOfOneTintIsNoHand) {
  const Mask mask = palm_and_arm();
  ColorImage frame(kWidth, kHeight, kWall);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask.data()[i] != 0) frame.data()[i] = kSkin;
  }
  EXPECT_EQ(area(find_hand(frame).hand), 0);
}

TEST(FindHand, AWallAloneAndOtherColorsAreNoHand) {
  EXPECT_EQ(area(find_hand(ColorImage(kWidth, kHeight, kWall)).hand), 0);
  const Bgr magenta = {200, 80, 200}, green = {60, 180, 60};
  EXPECT_EQ(area(find_hand(painted(palm_and_arm(), magenta)).hand), 0);
  EXPECT_EQ(area(find_hand(painted(palm_and_arm(), green)).hand), 0);
}

TEST(FindHand, ARegionOfManyReddishTonesIsNoHand) {
  const Mask mask = palm_and_arm();
  ColorImage frame = painted(mask, kSkin);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 160; x < kWidth; ++x) {
      const auto redder = static_cast<std::uint8_t>(std::min(2 * (x - 160), 60));
      if (mask.at(x, y) == 0) continue;
      frame.at(x, y) = {static_cast<std::uint8_t>(kSkin[0] - redder),
                        static_cast<std::uint8_t>(kSkin[1] - redder),
                        static_cast<std::uint8_t>(kSkin[2] + redder)};
    }
  }
  EXPECT_EQ(area(find_hand(frame).hand), 0);
}

}  // namespace
}  // namespace graspdb
