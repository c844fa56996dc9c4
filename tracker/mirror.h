// SPDX-License-Identifier: MIT
// A left hand is a right hand in the mirror.
#pragma once

#include "graspdb/image.h"
#include "graspdb/tracker.h"

namespace graspdb {

GrayImage mirrored(const GrayImage& image);
Intrinsics mirrored(const Intrinsics& camera);

// The estimate as seen without the mirror: x turns its sign in the camera frame and in the hand
// frame, which is then radial for x, and stays right-handed.
Estimate mirrored(Estimate estimate, int image_width);

}  // namespace graspdb
