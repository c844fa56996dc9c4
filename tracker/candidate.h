// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/tracker/tracker.h"
#include "placement.h"

namespace graspdb {

// A row as this camera would see it.
struct Tracker::Candidate {
  std::uint32_t row = 0;
  JointAngles angles;
  Placement placement;
  Eigen::Matrix3d rotation;  // of camera_from_hand
  PoseVector pose;
  double log_weight = 0;
  double weight = 0;
};

}  // namespace graspdb
