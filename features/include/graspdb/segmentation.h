// SPDX-License-Identifier: MIT
// Finds the hand in a camera frame.
#pragma once

#include <optional>

#include "graspdb/image.h"

namespace graspdb {

// A box in HSV (OpenCV's 8-bit units; hue is 0..179 and wraps around), as the paper has it.
struct SkinOptions {
  int hue_mean = 10, hue_range = 10;
  int saturation_mean = 133, saturation_range = 123;
  int value_mean = 129, value_range = 127;
  int min_area_px = 1000;  // smaller regions are no hand
};

// All skin-coloured pixels after a 5x5 closing.
Mask segment_skin(const ColorImage& frame, const SkinOptions& options = {});

// The largest connected region of the mask of at least min_area_px pixels that overlaps `roi` (the
// whole picture when absent); the others are cleared. None when there is no such region.
std::optional<Mask> largest_region(const Mask& mask, int min_area_px,
                                   const std::optional<Box>& roi = {});

// Cuts a bare forearm off: when the mask runs into the picture's border, what lies beyond the wrist
// on that side is cleared.
Mask cut_forearm(const Mask& hand);

GrayImage to_gray(const ColorImage& frame);

}  // namespace graspdb
