// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace graspdb {

// `count` rotations camera_from_hand that cover all orientations evenly: super-Fibonacci spirals
// (Alexa, CVPR 2022). With 648 of them the nearest is 13.6 degrees away on average.
std::vector<Eigen::Matrix3d> view_rotations(int count);

}  // namespace graspdb
