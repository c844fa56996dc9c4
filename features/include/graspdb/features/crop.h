// SPDX-License-Identifier: MIT
// The small square picture of a hand that a learned descriptor reads. The same code makes it of a
// rendered view and of a camera frame, with the same bytes on every processor.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "graspdb/core/image.h"

namespace graspdb {

constexpr int kCropSide = 64;  // pixels
constexpr std::size_t kCropPixels = std::size_t{kCropSide} * kCropSide;
using CropPlane = std::array<std::uint8_t, kCropPixels>;  // row by row

// What lies under each of its pixels, on average. Greys are relative to the hand's: its mean
// becomes kCropGray. In `gray` the standard deviation over the crop's pixels becomes kCropContrast,
// too, since pictures differ more in contrast than hands do; contrast is at most halved, and at
// most three times as large. Then all are cut to 0..255.
struct HandCrop {
  CropPlane gray{};   // of the mask's pixels, all others counted as 0
  CropPlane mask{};   // 255 where the mask covers it all
  CropPlane scene{};  // of all pixels; 0 beyond the picture
};
constexpr int kCropGray = 85, kCropContrast = 28;

// The square of the picture that a crop shows: the mask's tight box, made square and larger by 8 %.
struct CropSquare {
  int left_x2 = 0, top_x2 = 0;  // twice its corner, where 0 is the picture's own: whole numbers
  int side = 0;                 // pixels

  Eigen::Vector2d middle() const;  // pixel coordinates
};

// None for an empty mask.
std::optional<CropSquare> crop_square(const Mask& mask);

// `gray` and `mask` are of one size, of up to 16,384 pixels a side. Pure; thread-safe.
HandCrop crop_hand(const GrayImage& gray, const Mask& mask, const CropSquare& square);

}  // namespace graspdb
