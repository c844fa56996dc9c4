// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "graspdb/core/mesh.h"

namespace graspdb {

struct BoneShare {
  std::size_t bone;  // index into RigFile::bones
  double weight;     // > 0; those of a vertex sum to 1

  bool operator==(const BoneShare&) const = default;
};

// What a rigged file says of its rest pose, in its own coordinates and unit.
struct RigFile {
  std::string path;
  std::map<std::string, Eigen::Vector3d, std::less<>> joints;  // where every node lies
  std::vector<std::string> bones;                              // the nodes that can move skin
  // The skin of all its meshes, and the meshes without skin that hang from a bone; vertices that
  // the file splits along seams are one.
  Mesh mesh;
  std::vector<std::vector<BoneShare>> shares;  // one a vertex
};

// Reads what assimp reads. Throws Error when the file is unreadable, holds no skin, or holds a mesh
// that no bone moves.
RigFile read_rig_file(const std::filesystem::path& path);

}  // namespace graspdb
