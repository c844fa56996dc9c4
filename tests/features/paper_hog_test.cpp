// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "features/hog_bins.h"
#include "features/pictures.h"
#include "graspdb/core/file.h"
#include "graspdb/features/hog.h"
#include "graspdb/renderer/renderer.h"
#include "renderer/shapes.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::bin_at;
using testing::Picture;
using testing::random_picture;
using testing::TemporaryDirectory;

// An all-hand picture of this function of the pixel.
template <typename Gray>
Picture drawn(int width, int height, Gray gray) {
  Picture picture{GrayImage(width, height), Mask(width, height, 255)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.gray.at(x, y) = static_cast<std::uint8_t>(std::lround(gray(x, y)));
    }
  }
  return picture;
}

TEST(PaperHog, ATiltedRampFillsTheBinOfItsDirection) {
  for (const double angle_deg : {11.0, 34.0, 56.0, 79.0, 101.0, 124.0, 146.0, 169.0}) {
    const double c = 2.5 * std::cos(radians(angle_deg)), s = 2.5 * std::sin(radians(angle_deg));
    const Picture picture =
        drawn(64, 64, [&](int x, int y) { return 128 + c * (x - 32) + s * (y - 32); });
    const Descriptor descriptor = describe(picture.gray, picture.mask, HogMode::kPaper);
    // An inner cell: all 64 pixels are hand and vote alike, but for the grey levels' rounding.
    EXPECT_GT(bin_at(descriptor, 3, 4, static_cast<int>(angle_deg / 22.5)), 150) << angle_deg;
  }
}

TEST(PaperHog, AxisParallelAndDiagonalGradientsStartTheirBins) {
  const auto bin_of = [](int gx, int gy) {
    const Picture picture =
        drawn(64, 64, [&](int x, int y) { return 128 + gx * (x - 32) + gy * (y - 32); });
    const Descriptor descriptor = describe(picture.gray, picture.mask, HogMode::kPaper);
    for (int bin = 0; bin < 8; ++bin) {
      if (bin_at(descriptor, 3, 3, bin) == 255) return bin;
    }
    return -1;
  };
  EXPECT_EQ(bin_of(1, 0), 0);
  EXPECT_EQ(bin_of(-1, 0), 0);
  EXPECT_EQ(bin_of(1, 1), 2);
  EXPECT_EQ(bin_of(-1, -1), 2);
  EXPECT_EQ(bin_of(0, 2), 4);
  EXPECT_EQ(bin_of(0, -2), 4);
  EXPECT_EQ(bin_of(1, -1), 6);
  EXPECT_EQ(bin_of(-1, 1), 6);
}

TEST(PaperHog, AddingABrightnessChangesNoInnerCell) {
  const auto wave = [](int x, int y) { return 100 + 40 * std::sin(0.2 * x) * std::cos(0.15 * y); };
  const Picture dark = drawn(90, 75, wave);
  const Picture light = drawn(90, 75, [&](int x, int y) { return 50 + std::lround(wave(x, y)); });
  const Descriptor a = describe(dark.gray, dark.mask, HogMode::kPaper),
                   b = describe(light.gray, light.mask, HogMode::kPaper);
  for (int row = 1; row < 7; ++row) {
    for (int column = 1; column < 7; ++column) {
      for (int bin = 0; bin < 8; ++bin)
        EXPECT_EQ(bin_at(a, row, column, bin), bin_at(b, row, column, bin));
    }
  }
}

TEST(PaperHog, HalfATurnPermutesTheCells) {
  const Picture picture = random_picture(5, 64, 48, 3);
  Picture turned = picture;
  std::reverse(turned.gray.begin(), turned.gray.end());
  std::reverse(turned.mask.begin(), turned.mask.end());
  const Descriptor a = describe(picture.gray, picture.mask, HogMode::kPaper);
  const Descriptor b = describe(turned.gray, turned.mask, HogMode::kPaper);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      for (int bin = 0; bin < 8; ++bin) {
        EXPECT_EQ(bin_at(a, row, column, bin), bin_at(b, 7 - row, 7 - column, bin));
      }
    }
  }
}

TEST(PaperHog, ACellWeighsItsShareOfHandPixels) {
  // A ramp along x; the lower half of every cell is no hand. What the mask's own edges vote, a cell
  // still sums to its share.
  Picture picture = drawn(64, 64, [](int x, int) { return 2 * x + 50; });
  for (int y = 0; y < 64; ++y) {
    if (y % 8 >= 4 && y != 63) std::fill_n(picture.mask.row(y), 64, std::uint8_t{0});
  }
  const Descriptor descriptor = describe(picture.gray, picture.mask, HogMode::kPaper);
  int sum = 0;
  for (int bin = 0; bin < 8; ++bin) sum += bin_at(descriptor, 3, 3, bin);
  EXPECT_NEAR(sum, 127.5, 4);
}

TEST(PaperHog, AFlatHandVotesOnlyAtItsOutline) {
  const Descriptor descriptor =
      describe(GrayImage(64, 64, 130), Mask(64, 64, 255), HogMode::kPaper);
  for (int bin = 0; bin < 8; ++bin) EXPECT_EQ(bin_at(descriptor, 3, 3, bin), 0);
  EXPECT_EQ(bin_at(descriptor, 3, 0, 0), 255);  // the left side: a horizontal gradient
  EXPECT_EQ(bin_at(descriptor, 0, 3, 4), 255);
}

// The pictures that the reference describes too: boxes smaller than a cell grid, not divisible by
// 8, at the picture's border, and a rendered one.
std::vector<Picture> reference_pictures() {
  std::vector<Picture> pictures;
  std::uint64_t seed = 0;
  for (const auto& [width, height] : {std::pair(1, 1),
                                      {5, 90},
                                      {90, 5},
                                      {7, 8},
                                      {8, 7},
                                      {9, 17},
                                      {63, 65},
                                      {71, 40},
                                      {128, 128},
                                      {127, 101},
                                      {301, 233}}) {
    for (const int border : {0, 3})
      pictures.push_back(random_picture(++seed, width, height, border));
  }
  const Mesh object = testing::sphere({0.03, 0, -0.03}, 0.02, 32);
  const Mesh hand = testing::capsule({0, 0, 0}, 0.03, 0.06, 48);
  const Scene scene(hand, {}, &object);
  const Camera camera =
      crop_camera(rotation_from_vector({0.3, 0.4, 0.9}), {0, 0, 0}, 0.7, hand.vertices, 128);
  const View view = render(scene, camera);
  pictures.push_back({view.shading, visible_hand(view)});
  pictures.push_back({GrayImage(10, 10, 5), Mask(10, 10)});
  return pictures;
}

void write_pictures(const std::filesystem::path& path, const std::vector<Picture>& pictures) {
  std::ofstream file(path, std::ios::binary);
  for (const Picture& picture : pictures) {
    const std::int32_t size[] = {picture.gray.width(), picture.gray.height()};
    file.write(reinterpret_cast<const char*>(size), sizeof size);
    const auto pixels = static_cast<std::streamsize>(picture.gray.size());
    file.write(reinterpret_cast<const char*>(picture.gray.data()), pixels);
    file.write(reinterpret_cast<const char*>(picture.mask.data()), pixels);
  }
}

std::string python_with_numpy() {
  for (const std::string python : {"/usr/bin/python3", "python3"}) {
    if (std::system((python + " -c 'import numpy' 2>/dev/null").c_str()) == 0) return python;
  }
  return {};
}

TEST(PaperHog, AgreesWithNumpyInAllValues) {
  const std::string python = python_with_numpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy";
  const TemporaryDirectory folder;
  const std::vector<Picture> pictures = reference_pictures();
  write_pictures(folder / "pictures", pictures);
  const std::string script = GRASPDB_SOURCE_DIR "/tests/features/hog_reference.py";
  const std::string command = python + " '" + script + "' '" + (folder / "pictures").string() +
                              "' '" + (folder / "out").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string out = read_text(folder / "out");
  ASSERT_EQ(out.size(), 512 * pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Descriptor ours = describe(pictures[i].gray, pictures[i].mask, HogMode::kPaper);
    Descriptor theirs;
    std::copy_n(out.begin() + static_cast<std::ptrdiff_t>(512 * i), 512, theirs.begin());
    EXPECT_EQ(ours, theirs) << "picture " << i;
  }
}

}  // namespace
}  // namespace graspdb
