// SPDX-License-Identifier: MIT
#include "glb.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "graspdb/core/assimp/glb.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/digits.h"

namespace graspdb {

namespace {

using Json = nlohmann::ordered_json;  // keys stay as written

// Numbers of the glTF specification.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kFloat = 5126;
constexpr std::size_t kJointCount = kBoneCount + kDigitCount;
constexpr double kForearmJointM = .25;  // from the wrist, about where an elbow is

class GlbWriter {
 public:
  explicit GlbWriter(const Hand& hand) : hand_(hand) {
    for (std::size_t b = 0; b < kBoneCount; ++b)
      hand_from_joint_[b] = hand.hand_from_bone_at_bind[b];
    RigidTransform& forearm = hand_from_joint_[kForearm];
    forearm.translation = forearm * Eigen::Vector3d(0, -kForearmJointM, 0);
    for (std::size_t tip = 0; tip < kDigitCount; ++tip) {
      const auto distal = static_cast<std::size_t>(parent_of(kBoneCount + tip));
      hand_from_joint_[kBoneCount + tip] = {
          hand_from_joint_[distal].rotation,
          hand_from_joint_[distal] * hand.skeleton.tip_in_distal[tip]};
    }
  }

  std::string write() {
    Json attributes;
    attributes["POSITION"] = add_vectors(hand_.bind_mesh.vertices, true);
    attributes["NORMAL"] = add_vectors(hand_.bind_mesh.normals, false);
    if (!hand_.bind_mesh.albedo.empty()) attributes["COLOR_0"] = add_colors();
    add_weights(attributes);
    const std::size_t indices = add_indices();
    const std::size_t inverse_binds = add_inverse_binds();
    Json joints = Json::array();
    for (std::size_t joint = 0; joint < kJointCount; ++joint) joints.push_back(joint + 1);
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "graspdb"}};
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", {0, 1}}}};
    json["nodes"] = nodes();
    json["meshes"] = {{{"name", hand_.name},
                       {"primitives", {{{"attributes", attributes}, {"indices", indices}}}}}};
    json["skins"] = {{{"inverseBindMatrices", inverse_binds}, {"skeleton", 1}, {"joints", joints}}};
    json["accessors"] = accessors_;
    json["bufferViews"] = views_;
    json["buffers"] = {{{"byteLength", binary_.size()}}};
    return glb_file(json.dump(), binary_);
  }

 private:
  static int parent_of(std::size_t joint) {
    if (joint < kBoneCount) return bone_parent(static_cast<int>(joint));
    return distal_bone(static_cast<int>(joint - kBoneCount));
  }

  static std::string_view name_of(int joint) {
    return joint < kBoneCount ? bone_name(joint) : keypoint_name(tip_keypoint(joint - kBoneCount));
  }

  template <typename T>
  void append(const T& value) {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    binary_.append(bytes, sizeof(T));
  }

  // Describes what was appended since `start`.
  std::size_t add_accessor(std::size_t start, std::size_t count, int component, const char* type,
                           int target) {
    Json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", binary_.size() - start}};
    if (target != 0) view["target"] = target;
    Json accessor = {{"bufferView", views_.size()},
                     {"componentType", component},
                     {"count", count},
                     {"type", type}};
    binary_.resize((binary_.size() + 3) / 4 * 4);
    views_.push_back(view);
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
  }

  std::size_t add_vectors(const std::vector<Eigen::Vector3f>& vectors, bool with_bounds) {
    const std::size_t start = binary_.size();
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& v : vectors) {
      for (int axis = 0; axis < 3; ++axis) append(v[axis]);
      box.extend(v);
    }
    const std::size_t accessor = add_accessor(start, vectors.size(), kFloat, "VEC3", kArrayBuffer);
    if (with_bounds) {
      accessors_[accessor]["min"] = {box.min().x(), box.min().y(), box.min().z()};
      accessors_[accessor]["max"] = {box.max().x(), box.max().y(), box.max().z()};
    }
    return accessor;
  }

  std::size_t add_colors() {
    const std::size_t start = binary_.size();
    for (const float gray : hand_.bind_mesh.albedo) {
      for (int channel = 0; channel < 3; ++channel) append(gray);
    }
    return add_accessor(start, hand_.bind_mesh.albedo.size(), kFloat, "VEC3", kArrayBuffer);
  }

  void add_weights(Json& attributes) {
    std::size_t start = binary_.size();
    for (const SkinWeights& skin : hand_.weights) append(skin.bone);
    attributes["JOINTS_0"] =
        add_accessor(start, hand_.weights.size(), kUnsignedByte, "VEC4", kArrayBuffer);
    start = binary_.size();
    for (const SkinWeights& skin : hand_.weights) append(skin.weight);
    attributes["WEIGHTS_0"] =
        add_accessor(start, hand_.weights.size(), kFloat, "VEC4", kArrayBuffer);
  }

  std::size_t add_indices() {
    const std::size_t start = binary_.size();
    GRASPDB_CHECK(hand_.bind_mesh.vertices.size() < 65535);
    for (const Triangle& triangle : hand_.bind_mesh.triangles) {
      for (const std::uint32_t vertex : triangle) append(static_cast<std::uint16_t>(vertex));
    }
    return add_accessor(start, 3 * hand_.bind_mesh.triangles.size(), kUnsignedShort, "SCALAR",
                        kElementArrayBuffer);
  }

  std::size_t add_inverse_binds() {
    const std::size_t start = binary_.size();
    for (const RigidTransform& hand_from_joint : hand_from_joint_) {
      const RigidTransform inverse = hand_from_joint.inverse();
      Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
      matrix.topLeftCorner<3, 3>() = inverse.rotation.cast<float>();
      matrix.topRightCorner<3, 1>() = inverse.translation.cast<float>();
      for (int i = 0; i < 16; ++i) append(matrix.data()[i]);  // by columns, as glTF has it
    }
    return add_accessor(start, kJointCount, kFloat, "MAT4", 0);
  }

  // Node 0 is the mesh, the joints follow.
  Json nodes() const {
    Json nodes = {{{"name", hand_.name}, {"mesh", 0}, {"skin", 0}}};
    for (std::size_t joint = 0; joint < kJointCount; ++joint) nodes.push_back(node_of(joint));
    return nodes;
  }

  Json node_of(std::size_t joint) const {
    RigidTransform parent_from_joint = hand_from_joint_[joint];
    if (const int parent = parent_of(joint); parent >= 0) {
      parent_from_joint =
          hand_from_joint_[static_cast<std::size_t>(parent)].inverse() * parent_from_joint;
    }
    const Eigen::Quaterniond q(parent_from_joint.rotation);
    const Eigen::Vector3d& t = parent_from_joint.translation;
    Json children = Json::array();
    for (std::size_t other = 0; other < kJointCount; ++other) {
      if (parent_of(other) == static_cast<int>(joint)) children.push_back(other + 1);
    }
    Json node = {{"name", name_of(static_cast<int>(joint))},
                 {"translation", {t.x(), t.y(), t.z()}},
                 {"rotation", {q.x(), q.y(), q.z(), q.w()}}};
    if (!children.empty()) node["children"] = children;
    return node;
  }

  const Hand& hand_;
  std::array<RigidTransform, kJointCount> hand_from_joint_;
  std::string binary_;
  Json accessors_ = Json::array();
  Json views_ = Json::array();
};

}  // namespace

std::string hand_to_glb(const Hand& hand) {
  return GlbWriter(hand).write();
}

}  // namespace graspdb
