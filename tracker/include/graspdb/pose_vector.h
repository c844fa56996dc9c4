// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>

#include "graspdb/angles.h"
#include "graspdb/descriptor.h"

namespace graspdb {

// What poses are compared in (Romero et al. 2010): the 9 entries of the rotation matrix, row by
// row, and the sines of the 28 angles. The paper's pose error is the Euclidean norm of a
// difference.
using PoseVector = Eigen::Matrix<double, 9 + kAngleCount, 1>;

PoseVector pose_vector(const Eigen::Matrix3d& camera_from_hand, const JointAngles& angles);

// Opening a database does not check its content: an altered label may hold anything.
bool is_finite(std::span<const float, kLabelSize> label);

// The two halves of a row's label.
Eigen::Matrix3d label_rotation(std::span<const float, kLabelSize> label);  // camera_from_hand
JointAngles label_angles(std::span<const float, kLabelSize> label);

}  // namespace graspdb
