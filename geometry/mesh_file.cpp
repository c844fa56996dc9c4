// SPDX-License-Identifier: MIT
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file_name.h"
#include "graspdb/geometry/mesh_solid.h"
#include "graspdb/geometry/topology.h"
#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

constexpr float kSharpDegrees = 40;  // edges beyond that stay edges when drawn
constexpr unsigned kDrawnSteps = aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices;
// From here on assimp's steps would take most of the time and a kilobyte for each face.
constexpr std::size_t kManyFaces = 200000;

// All parts of a scene where its nodes show them. assimp's own way to do that leaves the triangles
// of mirrored parts turned inside out.
class SceneMesh {
 public:
  SceneMesh(const aiScene& scene, std::string file, double meters_per_unit)
      : scene_(scene), file_(std::move(file)), scale_(static_cast<float>(meters_per_unit)) {
    add(*scene.mRootNode, Eigen::Matrix4d::Identity());
  }
  Mesh mesh;

 private:
  void add(const aiNode& node, const Eigen::Matrix4d& file_from_parent) {
    const Eigen::Matrix4d file_from_node = file_from_parent * to_eigen(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& part = *scene_.mMeshes[node.mMeshes[i]];
      if ((part.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0)
        add(part, node.mName.C_Str(), file_from_node);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], file_from_node);
  }

  void add(const aiMesh& part, const std::string& node, const Eigen::Matrix4d& file_from_part) {
    const Eigen::Matrix3d turn = file_from_part.topLeftCorner<3, 3>();
    const double volume = turn.determinant();
    if (part.HasBones()) refuse(node, "a mesh that no bones move", "one with a skin");
    if (volume == 0) refuse(node, "a scale above 0", "0");
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Vector3d place = to_eigen(part.mVertices[v]).cast<double>();
      mesh.vertices.push_back(scale_ *
                              (file_from_part * place.homogeneous()).head<3>().cast<float>());
    }
    if (part.HasNormals()) add_normals(part, turn.inverse().transpose());
    for (Triangle t : triangles_of(part)) {
      if (volume < 0) std::swap(t[1], t[2]);
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  void add_normals(const aiMesh& part, const Eigen::Matrix3d& turn) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Vector3d normal = to_eigen(part.mNormals[v]).cast<double>();
      mesh.normals.push_back((turn * normal).cast<float>().normalized());
    }
  }

  [[noreturn]] void refuse(const std::string& key, const char* expected, const char* found) const {
    throw Error({file_, key, expected, found});
  }

  const aiScene& scene_;
  std::string file_;
  float scale_;
};

std::size_t face_count(const aiScene& scene) {
  std::size_t count = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) count += scene.mMeshes[i]->mNumFaces;
  return count;
}

// With normals of its own, also at edges: between so many triangles these are not seen.
Mesh smooth(Mesh mesh) {
  mesh.normals.assign(mesh.vertices.size(), Eigen::Vector3f::Zero());
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3f normal = normal_of(corners_of(mesh, t)).cast<float>();
    for (const std::uint32_t v : t) mesh.normals[v] += normal;
  }
  for (Eigen::Vector3f& normal : mesh.normals) normal.normalize();
  return mesh;
}

bool has_extension(const std::filesystem::path& file, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), lower_extension(file)) != names.end();
}

// What the file states and what is told of it must agree.
double meters_per_unit_of(const aiScene& scene, const std::filesystem::path& file,
                          std::optional<double> told) {
  const auto refuse = [&](const std::string& expected, const std::string& found) {
    throw Error({file.string(), "unit", expected, found});
  };
  const std::optional<double> stated = stated_meters_per_unit(scene);
  if (stated && !(*stated > 0)) refuse("a unit of more than 0 m", fmt::format("{:.4g}", *stated));
  if (stated && told && std::abs(*told / *stated - 1) > 1e-5) {
    refuse(fmt::format("the file's own, {:.4g} m, or no such key", *stated),
           fmt::format("{:g} m", *told));
  }
  if (!stated && !told && !has_extension(file, {".glb", ".gltf"})) {
    refuse("mm, cm or m, since the file does not state its own", "none");
  }
  return told.value_or(stated.value_or(1));  // glTF is in metres
}

}  // namespace

bool can_state_unit(const std::filesystem::path& file) {
  return has_extension(file, {".dae", ".fbx", ".glb", ".gltf"});
}

std::shared_ptr<const Solid> load_mesh_solid(const std::filesystem::path& file,
                                             std::optional<double> meters_per_unit) {
  Assimp::Importer importer;
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSharpDegrees);
  const aiScene* scene = &read_scene(importer, file, aiProcess_Triangulate, "a mesh");
  const bool has_many = face_count(*scene) > kManyFaces;
  if (!has_many) scene = importer.ApplyPostProcessing(kDrawnSteps);
  const double unit = meters_per_unit_of(*scene, file, meters_per_unit);
  const bool is_in_meters = has_extension(file, {".dae"}) && stated_meters_per_unit(*scene);
  Mesh mesh = SceneMesh(*scene, file.string(), is_in_meters ? 1 : unit).mesh;
  importer.FreeScene();
  if (has_many) mesh = smooth(welded(mesh));
  return make_mesh_solid(std::move(mesh), file);
}

}  // namespace graspdb
