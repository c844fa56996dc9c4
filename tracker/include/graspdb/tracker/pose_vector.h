// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "graspdb/hand/angles.h"

namespace graspdb {

// What poses are compared in (Romero et al. 2010): the 9 entries of the rotation matrix, row by
// row, and the sines of the 28 angles. The paper's pose error is the Euclidean norm of a
// difference.
using PoseVector = Eigen::Matrix<double, 9 + kAngleCount, 1>;

// `rotation` is that of camera_from_hand.
PoseVector pose_vector(const Eigen::Matrix3d& rotation, const JointAngles& angles);

}  // namespace graspdb
