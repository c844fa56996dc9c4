// SPDX-License-Identifier: MIT
// A free hand's pose and the side it is seen from, as a small TOML file (docs/export.md):
//   rotation_vector_deg = [x, y, z]                    camera_from_hand, or instead of it
//   yaw_deg, pitch_deg, roll_deg                       see rotation_from_turns
//   [angles_deg]
//   index_pip_flexion = 40                             by the names of angle_info(), absent: 0
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "graspdb/angles.h"

namespace graspdb {

struct PoseFile {
  Eigen::Matrix3d camera_from_hand;
  JointAngles angles;
};

// Throws Error naming file and key: an unknown name, an angle out of range.
PoseFile load_pose(const std::filesystem::path& file);

// camera_from_hand = Rz(roll) Rx(pitch) Ry(yaw) Rz(180 degrees), radians, about the camera's axes.
// At zero the palm faces the camera with the fingers up. Yaw turns the hand about the picture's
// vertical, at 180 degrees the back is seen; pitch tips the fingers towards the camera; roll turns
// the picture clockwise.
Eigen::Matrix3d rotation_from_turns(double yaw, double pitch, double roll);

}  // namespace graspdb
