// SPDX-License-Identifier: MIT
// The one way in which files of meshes and of rigged hands reach assimp, and what it reads in our
// types.
#pragma once

#include <assimp/scene.h>

#include <Eigen/Core>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/mesh.h"

namespace graspdb {

// Reads a file of any format that assimp reads, then takes the steps (aiProcess_...) of `steps`.
// The scene belongs to the importer. `what` the file should hold is for the message.
//
// assimp 5.2 trusts what a file says of itself. Therefore a .glb, .gltf or .obj is checked first,
// and assimp is given nothing of it but what makes a shape and its skin: no pictures, animations or
// morph targets. All that glTF 2.0 and KHR_mesh_quantization allow is read, buffers from the
// file's folder too; another extension that it requires and that may change the shape is refused,
// and so are two nodes of one name if a skin moves with one of them. Other formats are limited in
// size only.
//
// Axes are those of the file, and so is the unit, but that a COLLADA file's <unit> is applied: such
// a scene is in metres.
//
// In a scene that is returned every index is inside its array, and every vertex finite and at most
// 1e7 from the origin on each axis, in its mesh and in the scene. Throws Error.
const aiScene& read_scene(Assimp::Importer& importer, const std::filesystem::path& file,
                          unsigned steps, const std::string& what);

// The metres of a unit of the file, where it states them: COLLADA's <unit>, FBX's UnitScaleFactor.
// `scene` is of read_scene().
std::optional<double> stated_meters_per_unit(const aiScene& scene);

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
