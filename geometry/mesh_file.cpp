// SPDX-License-Identifier: MIT
#include <assimp/postprocess.h>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/geometry/mesh_solid.h"

namespace graspdb {
namespace {

constexpr float kSharpDegrees = 40;  // edges beyond that stay edges when drawn

void add(const aiMesh& part, double meters_per_unit, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto scale = static_cast<float>(meters_per_unit);
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    mesh.vertices.push_back(scale * to_eigen(part.mVertices[v]));
    mesh.normals.push_back(to_eigen(part.mNormals[v]).normalized());
  }
  for (const Triangle& t : triangles_of(part)) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace

std::shared_ptr<const Solid> load_mesh_solid(const std::filesystem::path& file,
                                             double meters_per_unit) {
  Assimp::Importer importer;
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSharpDegrees);
  const aiScene& scene =
      read_scene(importer, file,
                 aiProcess_PreTransformVertices | aiProcess_Triangulate |
                     aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices,
                 "a mesh");
  Mesh mesh;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    if (scene.mMeshes[i]->HasNormals()) add(*scene.mMeshes[i], meters_per_unit, mesh);
  }
  return make_mesh_solid(std::move(mesh), file);
}

}  // namespace graspdb
