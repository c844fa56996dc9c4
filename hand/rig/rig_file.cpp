// SPDX-License-Identifier: MIT
#include "rig_file.h"

#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/error.h"
#include "graspdb/geometry/topology.h"

namespace graspdb {
namespace {

constexpr double kSmallestWeight = 1e-6;  // importers give idle joints a weight of 0

float gray(const aiColor4D& color) {
  return (color.r + color.g + color.b) / 3;
}

// One vertex of the file at rest.
struct Corner {
  Eigen::Vector3f position, normal;
  float albedo;
  std::vector<BoneShare> shares;
  bool is_mirrored;  // on its way from the mesh: what faced outwards there turns
};

class SceneReader {
 public:
  SceneReader(const std::filesystem::path& path, const aiScene& scene) : scene_(scene) {
    file_.path = path.string();
  }

  RigFile read() {
    collect_poses(*scene_.mRootNode, Eigen::Matrix4d::Identity());
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) add_skin(*scene_.mMeshes[i]);
    if (file_.mesh.triangles.empty()) throw Error({file_.path, "", "a skinned mesh", "none"});
    add_parts(*scene_.mRootNode, Eigen::Matrix4d::Identity(), "");
    for (Eigen::Vector3f& normal : file_.mesh.normals) normal.normalize();
    return std::move(file_);
  }

 private:
  void collect_poses(const aiNode& node, const Eigen::Matrix4d& file_from_parent) {
    const Eigen::Matrix4d file_from_node = file_from_parent * to_eigen(node.mTransformation);
    if (poses_.emplace(node.mName.C_Str(), file_from_node).second) {
      file_.joints.emplace(node.mName.C_Str(), file_from_node.topRightCorner<3, 1>());
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      collect_poses(*node.mChildren[i], file_from_node);
    }
  }

  void add_skin(const aiMesh& mesh) {
    if (mesh.mNumBones == 0 || !mesh.HasNormals()) return;  // points and lines have none
    add_triangles(triangles_of(mesh), skin_corners(mesh));
  }

  // Meshes without skin, a nail or a ring: each moves as a whole with the bone of the skin that it
  // hangs from.
  void add_parts(const aiNode& node, const Eigen::Matrix4d& file_from_parent, std::string bone) {
    const Eigen::Matrix4d file_from_node = file_from_parent * to_eigen(node.mTransformation);
    const std::string name = node.mName.C_Str();
    if (std::ranges::find(file_.bones, name) != file_.bones.end()) bone = name;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[i]];
      if (mesh.mNumBones > 0 || !mesh.HasNormals()) continue;
      if (bone.empty()) {
        throw Error(
            {file_.path, name, "a mesh that is skin, or hangs from a bone of the skin", "neither"});
      }
      add_part(mesh, file_from_node, bone);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      add_parts(*node.mChildren[i], file_from_node, bone);
    }
  }

  void add_part(const aiMesh& mesh, const Eigen::Matrix4d& file_from_mesh,
                const std::string& bone) {
    std::vector<Corner> corners(mesh.mNumVertices);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      corners[v].shares = {{bone_index(bone), 1}};
      place(mesh, v, file_from_mesh.topRows<3>(), corners[v]);
    }
    add_triangles(triangles_of(mesh), std::move(corners));
  }

  void add_triangles(const std::vector<Triangle>& triangles, std::vector<Corner> corners) {
    std::vector<std::uint32_t> merged;
    std::vector<bool> is_mirrored;
    for (Corner& corner : corners) {
      is_mirrored.push_back(corner.is_mirrored);
      merged.push_back(add_corner(std::move(corner)));
    }
    for (const Triangle& t : triangles) {
      Triangle welded = {merged[t[0]], merged[t[1]], merged[t[2]]};
      if (is_mirrored[t[0]]) std::swap(welded[1], welded[2]);
      if (has_three_corners(welded)) file_.mesh.triangles.push_back(welded);
    }
  }

  std::vector<Corner> skin_corners(const aiMesh& mesh) {
    std::vector<Corner> corners(mesh.mNumVertices);
    std::vector<Eigen::Matrix<double, 3, 4>> blends(mesh.mNumVertices,
                                                    Eigen::Matrix<double, 3, 4>::Zero());
    for (unsigned b = 0; b < mesh.mNumBones; ++b) add_bone(*mesh.mBones[b], corners, blends);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      normalize(v, corners[v].shares, blends[v]);
      place(mesh, v, blends[v], corners[v]);
    }
    return corners;
  }

  void place(const aiMesh& mesh, unsigned v, const Eigen::Matrix<double, 3, 4>& file_from_mesh,
             Corner& corner) const {
    corner.position =
        (file_from_mesh * to_eigen(mesh.mVertices[v]).cast<double>().homogeneous()).cast<float>();
    if (!corner.position.allFinite()) fail(v, "a place", "no number");
    corner.is_mirrored = file_from_mesh.leftCols<3>().determinant() < 0;
    corner.normal =
        (file_from_mesh.leftCols<3>() * to_eigen(mesh.mNormals[v]).cast<double>()).cast<float>();
    if (!corner.normal.allFinite()) fail(v, "a normal", "no number");
    corner.albedo = mesh.HasVertexColors(0) ? gray(mesh.mColors[0][v]) : 1;
  }

  // `blends` takes each vertex from the mesh to the rest pose.
  void add_bone(const aiBone& bone, std::vector<Corner>& corners,
                std::vector<Eigen::Matrix<double, 3, 4>>& blends) {
    const Eigen::Matrix<double, 3, 4> rest_from_mesh =
        (pose_of(bone.mName.C_Str()) * to_eigen(bone.mOffsetMatrix)).topRows<3>();
    const std::size_t index = bone_index(bone.mName.C_Str());
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const auto& [v, weight] = bone.mWeights[i];
      if (!(weight > kSmallestWeight)) continue;
      corners.at(v).shares.push_back({index, weight});
      blends[v] += weight * rest_from_mesh;
    }
  }

  const Eigen::Matrix4d& pose_of(const std::string& bone) const {
    const auto pose = poses_.find(bone);
    if (pose == poses_.end()) throw Error({file_.path, bone, "a node that moves its skin", "none"});
    return pose->second;
  }

  std::size_t bone_index(const std::string& name) {
    const auto found = std::find(file_.bones.begin(), file_.bones.end(), name);
    const auto index = static_cast<std::size_t>(found - file_.bones.begin());
    if (found == file_.bones.end()) file_.bones.push_back(name);
    return index;
  }

  void normalize(unsigned v, std::vector<BoneShare>& shares,
                 Eigen::Matrix<double, 3, 4>& blend) const {
    double sum = 0;
    for (const BoneShare& share : shares) sum += share.weight;
    if (!(sum > 0)) fail(v, "a bone that moves it", "none");
    for (BoneShare& share : shares) share.weight /= sum;
    blend /= sum;
  }

  [[noreturn]] void fail(unsigned v, const std::string& expected, const std::string& found) const {
    throw Error({file_.path, fmt::format("vertex {}", v), expected, found});
  }

  // A file repeats a vertex for every texture coordinate or normal it has there; a closed surface
  // has it once. What moves differently, like two fingers that touch, stays two.
  std::uint32_t add_corner(Corner corner) {
    Mesh& mesh = file_.mesh;
    std::vector<std::uint32_t>& here =
        at_position_[{corner.position.x(), corner.position.y(), corner.position.z()}];
    for (const std::uint32_t v : here) {
      if (file_.shares[v] != corner.shares) continue;
      mesh.normals[v] += corner.normal;
      return v;
    }
    here.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    mesh.vertices.push_back(corner.position);
    mesh.normals.push_back(corner.normal);
    mesh.albedo.push_back(corner.albedo);
    file_.shares.push_back(std::move(corner.shares));
    return here.back();
  }

  const aiScene& scene_;
  RigFile file_;
  std::map<std::string, Eigen::Matrix4d, std::less<>> poses_;
  std::map<std::array<float, 3>, std::vector<std::uint32_t>> at_position_;
};

}  // namespace

RigFile read_rig_file(const std::filesystem::path& path) {
  Assimp::Importer importer;
  // Blender's names of a .dae's joints, not the ids that it derives from them.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  const aiScene& scene = read_scene(
      importer, path, aiProcess_Triangulate | aiProcess_GenSmoothNormals, "a rigged hand");
  return SceneReader(path, scene).read();
}

}  // namespace graspdb
