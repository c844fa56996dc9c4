// SPDX-License-Identifier: MIT
// The label of a row: the one place that knows how 31 numbers hold a pose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "graspdb/hand/angles.h"

namespace graspdb {

// The rotation vector of camera_from_hand, then the 28 joint angles, radians.
constexpr int kLabelSize = 3 + kAngleCount;
using Label = std::array<float, kLabelSize>;
using LabelView = std::span<const float, kLabelSize>;

struct LabelPose {
  Eigen::Matrix3d rotation;  // of camera_from_hand
  JointAngles angles;
};

// Pure; thread-safe. Unpacking gives what was packed to within the precision of a float.
Label pack_label(const LabelPose& pose);
LabelPose unpack_label(LabelView label);

// Opening a database does not check its content: an altered label may hold anything.
bool is_finite(LabelView label);

}  // namespace graspdb
