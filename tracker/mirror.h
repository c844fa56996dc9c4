// SPDX-License-Identifier: MIT
// A left hand is a right hand in the mirror.
#pragma once

#include "graspdb/core/image.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

Observation mirrored(const Observation& seen);

// The estimate as seen without the mirror: x turns its sign in the camera frame and in the hand
// frame, which is then radial for x, and stays right-handed.
Estimate mirrored(Estimate estimate, int image_width);

}  // namespace graspdb
