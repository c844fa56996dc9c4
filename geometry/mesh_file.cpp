// SPDX-License-Identifier: MIT
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "graspdb/core/error.h"
#include "graspdb/geometry/mesh_solid.h"

namespace graspdb {
namespace {

constexpr float kSharpDegrees = 40;  // edges beyond that stay edges when drawn

void add(const aiMesh& part, double meters_per_unit, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto scale = static_cast<float>(meters_per_unit);
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D& p = part.mVertices[v];
    const aiVector3D& n = part.mNormals[v];
    mesh.vertices.push_back(scale * Eigen::Vector3f(p.x, p.y, p.z));
    mesh.normals.push_back(Eigen::Vector3f(n.x, n.y, n.z).normalized());
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;  // points and lines
    mesh.triangles.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

}  // namespace

std::shared_ptr<const Solid> load_mesh_solid(const std::filesystem::path& file,
                                             double meters_per_unit) {
  Assimp::Importer importer;
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSharpDegrees);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_PreTransformVertices | aiProcess_Triangulate |
                         aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr) {
    throw Error({.file = file.string(), .expected = "a mesh", .found = importer.GetErrorString()});
  }
  Mesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    if (scene->mMeshes[i]->HasNormals()) add(*scene->mMeshes[i], meters_per_unit, mesh);
  }
  for (const Eigen::Vector3f& v : mesh.vertices) {
    if (!v.allFinite()) {
      throw Error({.file = file.string(), .expected = "finite vertices", .found = "others"});
    }
  }
  return make_mesh_solid(std::move(mesh), file);
}

}  // namespace graspdb
