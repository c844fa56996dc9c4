// SPDX-License-Identifier: MIT
// What finding a hand does to its mask.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "graspdb/core/image.h"
#include "graspdb/core/random.h"
#include "graspdb/samples/sample_config.h"

namespace graspdb {

// How the forearm lies in a picture. None when it points at the camera or away from it.
struct ArmInPicture {
  Eigen::Vector2d wrist;    // pixels
  Eigen::Vector2d towards;  // unit, away from the hand
  double px_per_mm = 0;     // along it
  double px_per_mm_across = 0;
};

// The mask as it might have been found: the forearm cut off, noise, pieces lost and added, outlines
// thinner or fatter. All of it drawn, none of it certain.
Mask found_mask(Mask hand, const std::optional<ArmInPicture>& arm, const SampleConfig& config,
                RandomStream& random);

// The pixels of an ellipse, or of a rectangle, anywhere in the picture and turned anyhow; half its
// axes are such shares of the picture's side.
enum class Outline { kEllipse, kRectangle };
Mask draw_outline(int width, int height, Outline outline, double smallest, double largest,
                  RandomStream& random);

}  // namespace graspdb
