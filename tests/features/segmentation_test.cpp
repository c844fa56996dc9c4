// SPDX-License-Identifier: MIT
#include "graspdb/features/segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "features/pictures.h"
#include "graspdb/core/random.h"

namespace graspdb {
namespace {

using testing::area;

template <typename Pixel>
void fill(Image<Pixel>& image, const Box& box, Pixel value) {
  for (int y = box.y; y < box.y + box.height; ++y) {
    std::fill_n(image.row(y) + box.x, box.width, value);
  }
}

constexpr Box kHand{60, 40, 50, 60};

// A patch of one colour on another, both with a little noise.
ColorImage frame_of(const Bgr& skin, const Bgr& wall) {
  ColorImage frame(200, 150, wall);
  fill(frame, kHand, skin);
  RandomStream random(1);
  for (Bgr& pixel : frame) {
    for (std::uint8_t& sample : pixel) {
      sample = static_cast<std::uint8_t>(sample + random.below(5) - 2);
    }
  }
  return frame;
}

Mask hand_mask() {
  Mask mask(200, 150);
  fill(mask, kHand, std::uint8_t{255});
  return mask;
}

TEST(SegmentSkin, RednessFindsTheHandInWhiteWarmAndDimLight) {
  const Bgr skin{130, 150, 200}, wall{200, 205, 205};
  for (const auto& [blue, green, red] :
       {std::array{1.0, 1.0, 1.0}, {0.45, 0.8, 1.1}, {0.3, 0.3, 0.32}}) {
    const auto lit = [&](const Bgr& color) {
      return Bgr{static_cast<std::uint8_t>(blue * color[0]),
                 static_cast<std::uint8_t>(green * color[1]),
                 static_cast<std::uint8_t>(red * color[2])};
    };
    EXPECT_EQ(segment_skin(frame_of(lit(skin), lit(wall))), hand_mask()) << blue;
  }
}

TEST(SegmentSkin, RednessSplitsAgainWhenTheWallIsReddishToo) {
  ColorImage frame = frame_of({120, 140, 210}, {150, 170, 190});
  fill(frame, {0, 110, 200, 40}, Bgr{190, 200, 180});  // a floor that the first split parts off
  EXPECT_EQ(segment_skin(frame), hand_mask());
}

TEST(SegmentSkin, VioletIsNotRed) {
  ColorImage frame = frame_of({130, 150, 200}, {200, 205, 205});
  fill(frame, {130, 10, 60, 130}, Bgr{170, 60, 75});
  EXPECT_EQ(segment_skin(frame), hand_mask());
}

TEST(SegmentSkin, AGrayFrameHoldsNoHand) {
  const Mask mask = segment_skin(frame_of({90, 90, 90}, {160, 160, 160}));
  EXPECT_FALSE(largest_region(mask, SkinOptions{}.min_area_px));
}

TEST(SegmentSkin, TheBoxTakesHuesOnBothSidesOfRed) {
  SkinOptions options{.rule = SkinRule::kBox, .hue_mean = 2, .hue_range = 8};
  const Bgr gray{120, 120, 120};
  EXPECT_EQ(segment_skin(frame_of({60, 80, 200}, gray), options), hand_mask());  // hue 4
  EXPECT_EQ(segment_skin(frame_of({80, 60, 200}, gray), options), hand_mask());  // hue 176
  EXPECT_EQ(area(segment_skin(frame_of({60, 200, 80}, gray), options)), 0);      // green
  EXPECT_EQ(area(segment_skin(frame_of({120, 60, 200}, gray), options)), 0);     // hue 167
  options.value_range = 40;
  EXPECT_EQ(area(segment_skin(frame_of({60, 80, 200}, gray), options)), 0);  // too bright now
}

TEST(SegmentSkin, TheClosingFillsSpecks) {
  ColorImage frame = frame_of({130, 150, 200}, {200, 205, 205});
  for (int i = 0; i < 5; ++i) fill(frame, {65 + 8 * i, 50 + 8 * i, 2, 3}, Bgr{200, 205, 205});
  EXPECT_EQ(segment_skin(frame), hand_mask());
}

// A second way: grow the region of every pixel, one after the other.
std::vector<Mask> grown_regions(Mask mask) {
  std::vector<Mask> regions;
  for (int start = 0; start < static_cast<int>(mask.size()); ++start) {
    if (mask.data()[start] == 0) continue;
    Mask region(mask.width(), mask.height());
    std::vector<int> open{start};
    mask.data()[start] = 0;
    while (!open.empty()) {
      const int x = open.back() % mask.width(), y = open.back() / mask.width();
      open.pop_back();
      region.at(x, y) = 255;
      for (int ny = std::max(0, y - 1); ny <= std::min(mask.height() - 1, y + 1); ++ny) {
        for (int nx = std::max(0, x - 1); nx <= std::min(mask.width() - 1, x + 1); ++nx) {
          if (mask.at(nx, ny) == 0) continue;
          mask.at(nx, ny) = 0;
          open.push_back(ny * mask.width() + nx);
        }
      }
    }
    regions.push_back(region);
  }
  return regions;
}

TEST(LargestRegion, IsThatOfARegionGrower) {
  RandomStream random(2);
  for (int round = 0; round < 60; ++round) {
    Mask mask(static_cast<int>(1 + random.below(40)), static_cast<int>(1 + random.below(40)));
    const double density = random.uniform(0.05, 0.6);
    for (std::uint8_t& pixel : mask) pixel = random.uniform() < density ? 255 : 0;
    int largest = 0;
    for (const Mask& region : grown_regions(mask)) largest = std::max(largest, area(region));
    const std::optional<Mask> ours = largest_region(mask, 1);
    ASSERT_EQ(ours.has_value(), largest > 0);
    if (!ours) continue;
    EXPECT_EQ(area(*ours), largest);
    const std::vector<Mask> regions = grown_regions(mask);
    EXPECT_NE(std::find(regions.begin(), regions.end(), *ours), regions.end());
  }
}

TEST(LargestRegion, KeepsToTheRoiAndTheLeastArea) {
  Mask mask(100, 50);
  fill(mask, {5, 5, 20, 20}, std::uint8_t{255});
  fill(mask, {60, 10, 10, 10}, std::uint8_t{255});
  EXPECT_EQ(area(*largest_region(mask, 100)), 400);
  EXPECT_EQ(area(*largest_region(mask, 100, Box{65, 0, 30, 50})), 100);
  EXPECT_EQ(area(*largest_region(mask, 100, Box{24, 0, 60, 50})), 400);  // overlap is enough
  EXPECT_FALSE(largest_region(mask, 101, Box{65, 0, 30, 50}));
  EXPECT_FALSE(largest_region(mask, 0, Box{30, 0, 20, 50}));
  EXPECT_FALSE(largest_region(Mask(10, 10), 0));
}

TEST(ToGray, WeighsTheColorsAsRec601) {
  EXPECT_EQ(to_gray(ColorImage(3, 2, Bgr{10, 100, 200})), GrayImage(3, 2, 120));
}

}  // namespace
}  // namespace graspdb
