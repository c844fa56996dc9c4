// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "graspdb/descriptor.h"
#include "graspdb/image.h"
#include "graspdb/tracker.h"

namespace graspdb::cli {

// What one frame's overlay shows.
struct OverlayInput {
  const ColorImage& color;
  const Mask& hand;
  const Estimate& estimate;
  const Descriptor& hog;                 // of the frame
  const std::optional<ColorImage>& row;  // the estimated hand
  std::string caption;
};

// Frame with the projected skeleton | mask | HOG | estimated hand, all `height` pixels high, as
// figures 6 and 7 of the paper have them side by side.
ColorImage draw_overlay(const OverlayInput& input, int height);

}  // namespace graspdb::cli
