// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "features/hog_bins.h"
#include "features/pictures.h"
#include "graspdb/features/hog.h"
#include "graspdb/renderer/renderer.h"
#include "renderer/shapes.h"

namespace graspdb {
namespace {

using testing::bin_at;
using testing::Picture;

constexpr HogMode kEdges = HogMode::kSoftEdges;

double distance(const Descriptor& a, const Descriptor& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(double(a[i]) - double(b[i]), 2);
  return std::sqrt(sum);
}

TEST(EdgesHog, OutlinesVoteForTheirOrientationWhateverTheLight) {
  for (const int gray : {20, 100, 250}) {
    const Descriptor d =
        describe(GrayImage(96, 80, static_cast<std::uint8_t>(gray)), Mask(96, 80, 255), kEdges);
    EXPECT_GT(bin_at(d, 4, 0, 0), 150);  // the left and right sides
    EXPECT_GT(bin_at(d, 4, 7, 0), 150);
    EXPECT_GT(bin_at(d, 0, 4, 4), 150);  // top and bottom
    EXPECT_GT(bin_at(d, 7, 4, 4), 150);
    for (int bin = 0; bin < 8; ++bin) EXPECT_EQ(bin_at(d, 4, 4, bin), 0);
  }
}

TEST(EdgesHog, AnEdgeBetweenTwoBinsVotesForBoth) {
  // A dark half plane at 33.75 degrees: between the centres of bins 1 (22.5) and 2 (45).
  Picture picture{GrayImage(64, 64, 200), Mask(64, 64, 255)};
  const double c = std::cos(radians(33.75)), s = std::sin(radians(33.75));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double inside = std::clamp(c * (x - 36) + s * (y - 36) + 0.5, 0.0, 1.0);
      picture.gray.at(x, y) = static_cast<std::uint8_t>(std::lround(200 - 120 * inside));
    }
  }
  const Descriptor d = describe(picture.gray, picture.mask, kEdges);
  EXPECT_GT(bin_at(d, 4, 4, 1), 80);
  EXPECT_NEAR(bin_at(d, 4, 4, 1), bin_at(d, 4, 4, 2), 12);
  EXPECT_LT(std::max(bin_at(d, 4, 4, 4), bin_at(d, 4, 4, 6)), 20);
}

TEST(EdgesHog, AnEdgeBetweenTwoCellsVotesForBoth) {
  // Light to the left of x, dark to the right of it; cells are 8 wide, the fifth's centre is at 36.
  const auto step_at = [](int x) {
    Picture picture{GrayImage(64, 64, 200), Mask(64, 64, 255)};
    for (int y = 0; y < 64; ++y)
      std::fill(picture.gray.row(y) + x, picture.gray.row(y) + 64, std::uint8_t{80});
    return describe(picture.gray, picture.mask, kEdges);
  };
  const Descriptor between = step_at(32), inside = step_at(36);
  EXPECT_GT(bin_at(between, 3, 3, 0), 80);
  EXPECT_EQ(bin_at(between, 3, 3, 0), bin_at(between, 3, 4, 0));
  EXPECT_GT(bin_at(inside, 3, 4, 0), bin_at(between, 3, 4, 0));
  EXPECT_LT(bin_at(inside, 3, 3, 0), bin_at(inside, 3, 4, 0) / 2);
}

TEST(EdgesHog, ExposureAndFaintShadingDoNotMatter) {
  Picture bright{GrayImage(100, 100), Mask(100, 100, 255)};
  Picture dim = bright, grainy = bright;
  RandomStream random(4);
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const int gray = x + y > 100 ? 220 : 120;
      bright.gray.at(x, y) = static_cast<std::uint8_t>(gray);
      dim.gray.at(x, y) = static_cast<std::uint8_t>(gray / 2);
      grainy.gray.at(x, y) = static_cast<std::uint8_t>(gray + static_cast<int>(random.below(3)));
    }
  }
  const Descriptor d = describe(bright.gray, bright.mask, kEdges);
  EXPECT_LT(distance(d, describe(dim.gray, dim.mask, kEdges)), 1);
  EXPECT_LT(distance(d, describe(grainy.gray, grainy.mask, kEdges)), 0.02 * distance(d, {}));
}

TEST(EdgesHog, SizeAndLightChangeLessThanFifteenDegreesDo) {
  const Mesh fingers = testing::joined(testing::capsule({-0.011, 0, 0}, 0.01, 0.03, 48),
                                       testing::capsule({0.011, 0.02, 0}, 0.01, 0.03, 48));
  const Scene scene(fingers, {}, nullptr);
  const auto describe_view = [&](double turn_deg, int resolution, const Light& light) {
    const Eigen::Matrix3d rotation = rotation_from_vector({0.4, 0.2, radians(20 + turn_deg)});
    const View view =
        render(scene, crop_camera(rotation, {0, 0, 0}, 0.7, fingers.vertices, resolution), light);
    return describe(view.shading, visible_hand(view), kEdges);
  };
  const Light from_left{.towards_light_in_camera = {-0.6, -0.3, -1}};
  const Descriptor d = describe_view(0, 128, {});
  const double turned = distance(d, describe_view(15, 128, {}));
  EXPECT_LT(distance(d, describe_view(0, 300, {})), 0.5 * turned);
  EXPECT_LT(distance(d, describe_view(0, 300, from_left)), 0.75 * turned);
}

}  // namespace
}  // namespace graspdb
