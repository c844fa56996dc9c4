// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/tracker/tracker.h"
#include "placement.h"

namespace graspdb {

// A frame as a camera sees it that is rolled about its optical axis: the same hand, near other
// rows.
struct Tracker::Look {
  double roll_deg = 0;
  Intrinsics camera;
  Box box;
  DescriptorBytes code;
  std::vector<Neighbor> neighbors;  // nearest first
};

// A row as this camera would see it.
struct Tracker::Candidate {
  std::uint32_t row = 0;
  double roll_deg = 0;  // of the look that found it
  JointAngles angles;
  Placement placement;
  Eigen::Matrix3d rotation;  // of camera_from_hand
  PoseVector pose;
  double log_weight = 0;
  double weight = 0;
};

}  // namespace graspdb
