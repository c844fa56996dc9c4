// SPDX-License-Identifier: MIT
#include "graspdb/hand/hand.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace graspdb {

Mesh pose_skin(const Hand& hand, const PerBone<RigidTransform>& hand_from_bone) {
  PerBone<Eigen::Matrix<float, 3, 4>> posed_from_bind;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const RigidTransform moved = hand_from_bone[bone] * hand.hand_from_bone_at_bind[bone].inverse();
    posed_from_bind[bone] << moved.rotation.cast<float>(), moved.translation.cast<float>();
  }
  Mesh posed = hand.bind_mesh;
  for (std::size_t v = 0; v < posed.vertices.size(); ++v) {
    const SkinWeights& skin = hand.weights[v];
    Eigen::Matrix<float, 3, 4> blend = skin.weight[0] * posed_from_bind[skin.bone[0]];
    for (std::size_t i = 1; i < 4; ++i) {
      if (skin.weight[i] > 0) blend += skin.weight[i] * posed_from_bind[skin.bone[i]];
    }
    posed.vertices[v] = blend * posed.vertices[v].homogeneous();
    posed.normals[v] = (blend.leftCols<3>() * posed.normals[v]).normalized();
  }
  return posed;
}

Mesh pose_skin(const Hand& hand, const JointAngles& angles) {
  return pose_skin(hand, hand_from_bones(hand.skeleton, angles));
}

std::vector<std::uint8_t> strongest_bones(const Hand& hand) {
  std::vector<std::uint8_t> bones;
  bones.reserve(hand.weights.size());
  for (const SkinWeights& skin : hand.weights) {
    const auto strongest = std::max_element(skin.weight.begin(), skin.weight.end());
    bones.push_back(skin.bone[static_cast<std::size_t>(strongest - skin.weight.begin())]);
  }
  return bones;
}

}  // namespace graspdb
