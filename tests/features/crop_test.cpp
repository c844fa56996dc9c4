// SPDX-License-Identifier: MIT
#include "graspdb/features/crop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "features/pictures.h"

namespace graspdb {
namespace {

using testing::Picture;
using testing::random_picture;

// Mean of what lies under a pixel of the crop, by 128 x 128 points in it.
double sampled(const std::function<double(int, int)>& value, const Picture& picture,
               const CropSquare& square, int x, int y) {
  constexpr int kPoints = 128;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const double step = static_cast<double>(square.side) / kCropSide;
      const int column =
          static_cast<int>(std::floor(square.left_x2 / 2.0 + (x + (j + 0.5) / kPoints) * step));
      const int row =
          static_cast<int>(std::floor(square.top_x2 / 2.0 + (y + (i + 0.5) / kPoints) * step));
      const bool inside =
          column >= 0 && row >= 0 && column < picture.gray.width() && row < picture.gray.height();
      if (inside) sum += value(column, row);
    }
  }
  return sum / (kPoints * kPoints);
}

TEST(CropSquare, HoldsTheMaskInItsMiddle) {
  Mask mask(100, 80);
  EXPECT_FALSE(crop_square(mask));
  for (int y = 20; y < 60; ++y) std::fill(mask.row(y) + 70, mask.row(y) + 95, 255);
  const auto square = crop_square(mask);
  ASSERT_TRUE(square);
  EXPECT_EQ(square->side, 43);  // 40 pixels and 8 %
  EXPECT_EQ(square->middle(), Eigen::Vector2d(82, 39.5));
}

TEST(CropHand, ShowsWhatLiesUnderEachPixel) {
  for (const int size : {17, 70, 200}) {
    const Picture picture = random_picture(5, size, size * 3 / 4, 6);
    const CropSquare square = *crop_square(picture.mask);
    const HandCrop crop = crop_hand(picture.gray, picture.mask, square);
    for (int i = 0; i < 40; ++i) {
      const int x = i * 37 % kCropSide, y = i * 23 % kCropSide;
      const auto at = static_cast<std::size_t>(y * kCropSide + x);
      const double covered =
          sampled([&](int u, int v) { return picture.mask.at(u, v) != 0 ? 255.0 : 0.0; }, picture,
                  square, x, y);
      EXPECT_NEAR(crop.mask[at], covered, 4) << size << ": " << x << ", " << y;
    }
  }
}

TEST(CropHand, OfAnExactMultipleIsTheMeanOfItsBlocks) {
  GrayImage gray(128, 128, 0);
  Mask mask(128, 128, 0);
  for (int y = 5; y < 123; ++y) {
    for (int x = 5; x < 123; ++x) {
      mask.at(x, y) = 255;
      gray.at(x, y) = static_cast<std::uint8_t>(x < 64 ? 40 : 120);
    }
  }
  const CropSquare square{0, 0, 128};
  const HandCrop crop = crop_hand(gray, mask, square);
  // The hand's mean is 80 and its standard deviation 40.
  EXPECT_NEAR(crop.gray[32 * kCropSide + 10], kCropGray - kCropContrast, 1);
  EXPECT_NEAR(crop.gray[32 * kCropSide + 50], kCropGray + kCropContrast, 1);
  EXPECT_EQ(crop.mask[32 * kCropSide + 10], 255);
  EXPECT_EQ(crop.mask[32 * kCropSide + 2], 128);  // one column of two
  EXPECT_EQ(crop.mask[0], 0);
}

TEST(CropHand, DoesNotDependOnBrightness) {
  const Picture picture = random_picture(7, 90, 90, 5);
  Picture darker = picture;
  for (std::uint8_t& level : darker.gray) level = static_cast<std::uint8_t>(level / 2);
  const CropSquare square = *crop_square(picture.mask);
  const HandCrop a = crop_hand(picture.gray, picture.mask, square);
  const HandCrop b = crop_hand(darker.gray, picture.mask, square);
  for (std::size_t i = 0; i < kCropPixels; ++i) EXPECT_NEAR(a.gray[i], b.gray[i], 3);
}

// Four quarters of the picture, all of them the hand's.
HandCrop crop_of_quarters(std::array<std::uint8_t, 4> levels) {
  GrayImage gray(128, 128);
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      gray.at(x, y) = levels[static_cast<std::size_t>(x / 64 + y / 64 * 2)];
    }
  }
  return crop_hand(gray, Mask(128, 128, 255), CropSquare{0, 0, 128});
}

TEST(CropHand, DoesNotDependOnContrast) {
  const HandCrop a = crop_of_quarters({90, 110, 120, 80});
  const HandCrop b = crop_of_quarters({80, 120, 140, 60});
  EXPECT_GT(a.gray[63], a.gray[0] + 20);
  for (std::size_t i = 0; i < kCropPixels; ++i) EXPECT_NEAR(a.gray[i], b.gray[i], 1);
}

TEST(CropHand, ContrastIsAtMostHalved) {
  const HandCrop crop = crop_of_quarters({10, 10, 10, 250});  // mean 70, standard deviation 104
  EXPECT_NEAR(crop.gray[0], kCropGray * (1 - 60.0 / 70 / 2), 1);
  EXPECT_NEAR(crop.gray[kCropPixels - 1], kCropGray * (1 + 180.0 / 70 / 2), 1);
}

TEST(CropHand, WhatBecomesDarkerThanBlackIsBlack) {
  GrayImage gray(64, 64, 100);
  for (int x = 0; x < 64; ++x) gray.at(x, 0) = 20;
  const HandCrop crop = crop_hand(gray, Mask(64, 64, 255), CropSquare{0, 0, 64});
  EXPECT_EQ(crop.gray[0], 0);
  EXPECT_GT(crop.gray[kCropPixels - 1], kCropGray);
}

TEST(CropHand, NoiseOfAFlatHandBecomesThreeTimesAsMuchAndNoMore) {
  const HandCrop crop = crop_of_quarters({85, 86, 85, 84});
  EXPECT_EQ(crop.gray[0], kCropGray);
  EXPECT_EQ(crop.gray[63], kCropGray + 3);
  EXPECT_EQ(crop.gray[kCropPixels - 1], kCropGray - 3);
}

TEST(CropHand, WhatIsOutsideTheMaskIsInTheSceneAlone) {
  const Picture picture = random_picture(3, 70, 50, 6);
  Picture other = picture;
  for (std::size_t i = 0; i < other.gray.size(); ++i) {
    if (other.mask.data()[i] == 0) other.gray.data()[i] = 250;
  }
  const CropSquare square = *crop_square(picture.mask);
  const HandCrop a = crop_hand(picture.gray, picture.mask, square);
  const HandCrop b = crop_hand(other.gray, picture.mask, square);
  EXPECT_EQ(a.gray, b.gray);
  EXPECT_EQ(a.mask, b.mask);
  EXPECT_NE(a.scene, b.scene);
}

TEST(CropHand, ABlackHandHasAMaskAndNoGrey) {
  GrayImage gray(30, 30, 0);
  Mask mask(30, 30, 255);
  const HandCrop crop = crop_hand(gray, mask, *crop_square(mask));
  EXPECT_EQ(std::ranges::max(crop.gray), 0);
  EXPECT_EQ(std::ranges::max(crop.mask), 255);
}

TEST(CropHand, BeyondThePictureIsNothing) {
  GrayImage gray(20, 200, 100);
  Mask mask(20, 200, 255);
  const HandCrop crop = crop_hand(gray, mask, *crop_square(mask));
  EXPECT_EQ(crop.scene[32 * kCropSide], 0);
  EXPECT_EQ(crop.scene[32 * kCropSide + 32], kCropGray);
}

}  // namespace
}  // namespace graspdb
