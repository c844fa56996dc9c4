// SPDX-License-Identifier: MIT
// Whether a region can be a hand at all. The limits were set on photographs with and without hands
// (docs/benchmarks.md); every one of the 20 photographs and 62 video frames with a hand is within.
#pragma once

#include "graspdb/core/image.h"

namespace graspdb {

// A hand's outline is long but not endless, and an arm leaves the picture in one place.
bool has_shape_of_hand(const Mask& region);

// The region's median hue is skin's, and its redness varies as one skin's does under one light.
bool has_color_of_skin(const ColorImage& frame, const Mask& region);

}  // namespace graspdb
