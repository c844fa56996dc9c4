// SPDX-License-Identifier: MIT
// What assimp reads, in our types.
#pragma once

#include <assimp/scene.h>

#include <Eigen/Core>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/mesh.h"

namespace graspdb {

// The scene lives as long as the importer. `what` the file should hold is for the Error that is
// thrown when it cannot be read; `steps` are assimp's flags.
inline const aiScene& read_scene(Assimp::Importer& importer, const std::filesystem::path& file,
                                 unsigned steps, const std::string& what) {
  const aiScene* scene = importer.ReadFile(file.string(), steps);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error({file.string(), "", what, importer.GetErrorString()});
  }
  return *scene;
}

inline Eigen::Vector3f to_eigen(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

inline Eigen::Matrix4d to_eigen(const aiMatrix4x4& m) {
  return Eigen::Map<const Eigen::Matrix<ai_real, 4, 4, Eigen::RowMajor>>(&m.a1).cast<double>();
}

// Its faces of three corners; lines and points are left out.
inline std::vector<Triangle> triangles_of(const aiMesh& mesh) {
  std::vector<Triangle> triangles;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices != 3) continue;
    triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return triangles;
}

}  // namespace graspdb
