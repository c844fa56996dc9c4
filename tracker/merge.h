// SPDX-License-Identifier: MIT
// Answers between the rows.
#pragma once

#include <Eigen/Core>

#include "graspdb/hand/angles.h"

namespace graspdb {

// Of rows that are merged, a line each. A pose: rotation vector, place (x / z, y / z, log z of the
// palm), angles.
using PoseLine = Eigen::Matrix<float, 1, 3 + 3 + kAngleCount>;
using PoseLines = Eigen::Matrix<float, Eigen::Dynamic, PoseLine::ColsAtCompileTime>;
using CodeLines =
    Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // less what was seen
using LineWeights = Eigen::VectorXf;

// Linear regression weighted by nearness (Cleveland 1979): the pose where the code is 0. It never
// leaves what the lines span. Weights are not negative and sum to 1.
PoseLine fitted_pose(const PoseLines& poses, const CodeLines& codes, const LineWeights& weights);

}  // namespace graspdb
