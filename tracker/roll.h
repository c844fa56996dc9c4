// SPDX-License-Identifier: MIT
// Frames as cameras see them that are rolled about their optical axis.
#pragma once

#include "graspdb/tracker/tracker.h"

namespace graspdb {

// Turned clockwise by roll_deg; what lies around the hand alone, whose box is given, with pixels
// that are square, and larger where the hand has very many.
Observation rolled(const Observation& seen, const Box& hand, double roll_deg);

// Takes what such a camera sees back to the frame's own.
Eigen::Matrix3d camera_from_rolled(double roll_deg);

}  // namespace graspdb
