// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace graspdb {

// The name of view_rotations, as databases store it.
constexpr const char* kViewRule = "fibonacci-rolls";

// `count` rotations camera_from_hand that cover all orientations evenly: the camera looks along the
// directions of a spherical Fibonacci lattice and is rolled evenly about each. With 648 of them, 54
// directions with 12 rolls, the nearest is 13.5 degrees away on average; docs/views.md compares.
std::vector<Eigen::Matrix3d> view_rotations(int count);

// The same with another number of directions, 1..count; their numbers of rolls differ by at most
// one. The rolls of a direction are neighbours.
std::vector<Eigen::Matrix3d> rolled_directions(int directions, int count);

}  // namespace graspdb
