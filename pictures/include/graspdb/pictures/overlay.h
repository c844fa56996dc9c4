// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "graspdb/core/image.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// What one frame's overlay shows.
struct OverlayInput {
  const ColorImage& color;
  const Estimate& estimate;
  const std::optional<ColorImage>& answer;  // the estimated hand: EstimatePicture
  std::string caption;
};

// The frame, with the skeleton of a valid answer and the box of the hand that was found.
ColorImage with_skeleton(const ColorImage& frame, const Estimate& estimate);

// Frame with the projected skeleton | mask | HOG | estimated hand, all `height` pixels high, as
// figures 6 and 7 of the paper have them side by side.
ColorImage draw_overlay(const OverlayInput& input, int height);

}  // namespace graspdb
