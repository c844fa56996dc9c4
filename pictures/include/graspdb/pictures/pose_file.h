// SPDX-License-Identifier: MIT
// A free hand's pose and the side it is seen from, as a small TOML file (docs/export.md):
//   rotation_vector_deg = [x, y, z]                    of camera_from_hand, or instead of it
//   view_deg = [yaw, pitch, roll]                      as in sequences: see rotation_from_turns
//   [angles_deg]
//   index_pip_flexion = 40                             by the names of angle_info(), absent: 0
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "graspdb/hand/angles.h"

namespace graspdb {

struct PoseFile {
  Eigen::Matrix3d rotation;  // of camera_from_hand
  JointAngles angles;
};

// Throws Error naming file and key: an unknown name, an angle out of range.
PoseFile load_pose(const std::filesystem::path& file);

}  // namespace graspdb
