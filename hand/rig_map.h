// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "graspdb/skeleton.h"

namespace graspdb {

// What a rigged file's bones are to graspdb: the text file beside it.
struct RigMap {
  std::string file;  // of the map itself, for messages
  bool is_left = false;
  double metres_per_unit = 1;
  Eigen::Vector3d thumb_nail;  // unit vector, the file's coordinates in its rest pose
  // The first of a bone's names gives the joint; the skin of all of them moves with it.
  PerBone<std::vector<std::string>> bones;
  std::array<std::string, 5> tips;
};

RigMap load_rig_map(const std::filesystem::path& path);

}  // namespace graspdb
