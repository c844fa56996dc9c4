// SPDX-License-Identifier: MIT
#include "graspdb/rig.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <map>
#include <optional>

#include "graspdb/error.h"
#include "rest_frames.h"
#include "rig_map.h"

namespace graspdb {
namespace {

constexpr double kSmallestWeight = 1e-6;  // importers give idle joints a weight of 0
constexpr double kShortestHandM = .10, kLongestHandM = .24;

Eigen::Matrix4d to_matrix(const aiMatrix4x4& m) {
  return Eigen::Map<const Eigen::Matrix<ai_real, 4, 4, Eigen::RowMajor>>(&m.a1).cast<double>();
}

Eigen::Vector3d to_vector(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

float grey(const aiColor4D& colour) {
  return (colour.r + colour.g + colour.b) / 3;
}

using NodePoses = std::map<std::string, Eigen::Matrix4d, std::less<>>;

void collect_poses(const aiNode& node, const Eigen::Matrix4d& file_from_parent, NodePoses& poses) {
  const Eigen::Matrix4d file_from_node = file_from_parent * to_matrix(node.mTransformation);
  poses.emplace(node.mName.C_Str(), file_from_node);
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    collect_poses(*node.mChildren[i], file_from_node, poses);
  }
}

// The skin in the file's rest pose, and which canonical bones move it.
struct RestSkin {
  Mesh mesh;
  std::vector<PerBone<double>> weights;
};

class RigReader {
 public:
  RigReader(const std::filesystem::path& file, const RigMap& map, const aiScene& scene)
      : file_(file.string()), map_(map), scene_(scene) {
    collect_poses(*scene.mRootNode, Eigen::Matrix4d::Identity(), poses_);
    // The mirror makes a left hand a right one; the scale makes its unit the metre.
    metres_from_file_.diagonal() << map.metres_per_unit * (map.is_left ? -1 : 1),
        map.metres_per_unit, map.metres_per_unit;
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      for (const std::string& name : map.bones[bone]) {
        if (!canonical_.emplace(name, bone).second) {
          fail(bone_key(bone), "every bone once", name + " twice");
        }
      }
    }
    for (std::size_t tip = 0; tip < 5; ++tip) {
      const int distal = tip == 0 ? static_cast<int>(kThumbDistal)
                                  : finger_bone(static_cast<int>(tip) - 1, kDistal);
      canonical_.emplace(map.tips[tip], static_cast<std::size_t>(distal));
    }
  }

  Hand read() {
    const RestFrames frames = frames_from_joints(read_joints());
    check(frames);
    RestSkin skin = read_skin();
    Hand hand;
    hand.name = std::filesystem::path(file_).stem().string();
    hand.skeleton = frames.skeleton;
    hand.palm_from_bone_at_bind = frames.palm_from_bone;
    hand.bind_mesh = std::move(skin.mesh);
    for (Eigen::Vector3f& v : hand.bind_mesh.vertices) {
      v = (frames.palm_from_file * v.cast<double>()).cast<float>();
    }
    for (Eigen::Vector3f& n : hand.bind_mesh.normals) {
      n = (frames.palm_from_file.rotation * n.cast<double>()).cast<float>();
    }
    for (const PerBone<double>& weights : skin.weights) {
      hand.weights.push_back(four_largest(weights));
    }
    return hand;
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& expected,
                         const std::string& found) const {
    throw Error({map_.file, key, expected, found + " in " + file_});
  }

  static std::string bone_key(std::size_t bone) {
    return fmt::format("bones.{}", bone_name(static_cast<int>(bone)));
  }

  Eigen::Vector3d joint_position(const std::string& name, const std::string& key) const {
    const auto pose = poses_.find(name);
    if (pose == poses_.end()) fail(key, "a joint of the file", "no \"" + name + "\"");
    return metres_from_file_ * pose->second.topRightCorner<3, 1>();
  }

  RestJoints read_joints() const {
    RestJoints joints;
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      for (const std::string& name : map_.bones[bone]) joint_position(name, bone_key(bone));
      joints.origins[bone] = joint_position(map_.bones[bone].front(), bone_key(bone));
    }
    for (std::size_t tip = 0; tip < 5; ++tip) {
      joints.tips[tip] = joint_position(map_.tips[tip], "tips");
    }
    joints.thumb_nail = (metres_from_file_ * map_.thumb_nail).normalized();
    return joints;
  }

  void check(const RestFrames& frames) const {
    const double length = hand_length(frames.skeleton);
    if (!(length >= kShortestHandM && length <= kLongestHandM)) {
      fail("metres_per_unit", fmt::format("a hand of {} to {} m", kShortestHandM, kLongestHandM),
           fmt::format("{:.4g} m", length));
    }
    if (!(frames.skeleton.palm_from_bone_at_zero[kThumbMetacarpal].translation.x() < 0)) {
      fail("bones.index_proximal", "the index on the thumb's side", "the little finger there");
    }
    // In a mirrored hand what is taken for the palm is its back: thumb and fingers bend away.
    const Keypoints rest = keypoints_in_palm(frames.skeleton, frames.palm_from_bone);
    if (!(rest(2, 4) + rest(2, 8) + rest(2, 12) + rest(2, 16) + rest(2, 20) < 0)) {
      fail("handedness", map_.is_left ? "a left hand" : "a right hand",
           "digits that bend to the back of such a hand");
    }
  }

  RestSkin read_skin() const {
    RestSkin skin;
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) add_mesh(*scene_.mMeshes[i], skin);
    if (skin.mesh.triangles.empty()) throw Error({file_, "", "a skinned mesh", "none"});
    return skin;
  }

  void add_mesh(const aiMesh& mesh, RestSkin& skin) const {
    if (mesh.mNumBones == 0) return;
    const auto first = static_cast<std::uint32_t>(skin.mesh.vertices.size());
    const std::vector<Eigen::Matrix<double, 3, 4>> blends = read_weights(mesh, skin);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const Eigen::Vector3d normal =
          metres_from_file_ * (blends[v].leftCols<3>() * to_vector(mesh.mNormals[v]));
      skin.mesh.vertices.push_back(
          (metres_from_file_ * (blends[v] * to_vector(mesh.mVertices[v]).homogeneous()))
              .cast<float>());
      skin.mesh.normals.push_back(normal.normalized().cast<float>());
      skin.mesh.albedo.push_back(mesh.HasVertexColors(0) ? grey(mesh.mColors[0][v]) : 1);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      Triangle triangle = {first + face.mIndices[0], first + face.mIndices[1],
                           first + face.mIndices[2]};
      if (map_.is_left) std::swap(triangle[1], triangle[2]);
      skin.mesh.triangles.push_back(triangle);
    }
  }

  // Adds the weights of the mesh's vertices; returns what takes each from the mesh to the rest
  // pose.
  std::vector<Eigen::Matrix<double, 3, 4>> read_weights(const aiMesh& mesh, RestSkin& skin) const {
    const std::size_t first = skin.weights.size();
    skin.weights.resize(first + mesh.mNumVertices, PerBone<double>{});
    std::vector<Eigen::Matrix<double, 3, 4>> blends(mesh.mNumVertices,
                                                    Eigen::Matrix<double, 3, 4>::Zero());
    std::vector<double> sums(mesh.mNumVertices, 0);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      for (unsigned i = 0; i < bone.mNumWeights; ++i) {
        const auto& [v, weight] = bone.mWeights[i];
        if (!(weight > kSmallestWeight)) continue;
        skin.weights[first + v][canonical_bone(bone)] += weight;
        blends[v] += weight * rest_from_mesh(bone);
        sums[v] += weight;
      }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
      if (!(sums[v] > 0)) {
        throw Error({file_, fmt::format("vertex {}", v), "a bone that moves it", "none"});
      }
      blends[v] /= sums[v];
    }
    return blends;
  }

  std::size_t canonical_bone(const aiBone& bone) const {
    const auto found = canonical_.find(bone.mName.C_Str());
    if (found == canonical_.end()) {
      fail("bones", "every bone that moves skin",
           fmt::format("\"{}\", which is not mapped,", bone.mName.C_Str()));
    }
    return found->second;
  }

  Eigen::Matrix<double, 3, 4> rest_from_mesh(const aiBone& bone) const {
    return (poses_.at(bone.mName.C_Str()) * to_matrix(bone.mOffsetMatrix)).topRows<3>();
  }

  static SkinWeights four_largest(const PerBone<double>& weights) {
    std::array<std::uint8_t, kBoneCount> order{};
    for (std::uint8_t i = 0; i < kBoneCount; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += weights[order[i]];
    SkinWeights skin;
    for (std::size_t i = 0; i < 4 && weights[order[i]] > kSmallestWeight; ++i) {
      skin.bone[i] = order[i];
      skin.weight[i] = static_cast<float>(weights[order[i]] / sum);
    }
    return skin;
  }

  std::string file_;
  const RigMap& map_;
  const aiScene& scene_;
  Eigen::DiagonalMatrix<double, 3> metres_from_file_;
  NodePoses poses_;
  std::map<std::string, std::size_t, std::less<>> canonical_;
};

}  // namespace

std::filesystem::path rig_map_beside(const std::filesystem::path& hand_file) {
  std::filesystem::path path = hand_file;
  return path.replace_extension(".rig.toml");
}

Hand load_hand(const std::filesystem::path& hand_file, const std::filesystem::path& rig_map) {
  Assimp::Importer importer;
  // Texture seams would split the skin.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                              aiComponent_TEXCOORDS | aiComponent_TANGENTS_AND_BITANGENTS);
  const aiScene* scene = importer.ReadFile(
      hand_file.string(), aiProcess_RemoveComponent | aiProcess_Triangulate |
                              aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error({hand_file.string(), "", "a rigged hand", importer.GetErrorString()});
  }
  const RigMap map = load_rig_map(rig_map);
  return RigReader(hand_file, map, *scene).read();
}

Hand load_hand(const std::filesystem::path& hand_file) {
  return load_hand(hand_file, rig_map_beside(hand_file));
}

}  // namespace graspdb
