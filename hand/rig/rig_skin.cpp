// SPDX-License-Identifier: MIT
#include "rig_skin.h"

#include <fmt/format.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "rig_fault.h"
#include "rig_joints.h"

namespace graspdb {
namespace {

constexpr double kSmallestShare = 1e-6;
constexpr float kFarthestSkinM = .6F;  // from the wrist: an arm to beyond the elbow

void check_reach(const RigMap& map, const RigFile& file, const Mesh& skin_in_hand) {
  for (std::size_t v = 0; v < skin_in_hand.vertices.size(); ++v) {
    const float distance = skin_in_hand.vertices[v].norm();
    if (distance <= kFarthestSkinM) continue;
    fail(map, file, "bones", fmt::format("skin within {} m of the wrist", kFarthestSkinM),
         fmt::format("\"{}\", which moves some at {:.3g} m,", file.bones[file.shares[v][0].bone],
                     distance));
  }
}

std::vector<int> bones_of_file(const RigMap& map, const RigFile& file) {
  std::vector<int> bones;
  for (const std::string& name : file.bones) {
    const auto found = map.bone_of_name.find(name);
    bones.push_back(found == map.bone_of_name.end() ? -1 : found->second);
  }
  return bones;
}

SkinWeights four_largest(const PerBone<double>& weights) {
  std::array<std::uint8_t, kBoneCount> order{};
  for (std::uint8_t i = 0; i < kBoneCount; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b]; });
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += weights[order[i]];
  SkinWeights skin;
  for (std::size_t i = 0; i < 4 && weights[order[i]] > kSmallestShare; ++i) {
    skin.bone[i] = order[i];
    skin.weight[i] = static_cast<float>(weights[order[i]] / sum);
  }
  return skin;
}

}  // namespace

RigSkin skin_in_hand(const RigMap& map, const RigFile& file, const RigidTransform& hand_from_file) {
  RigSkin skin{.mesh = file.mesh, .weights = {}};
  const Eigen::DiagonalMatrix<double, 3> meters = meters_from_file(map);
  for (Eigen::Vector3f& v : skin.mesh.vertices) {
    v = (hand_from_file * (meters * v.cast<double>())).cast<float>();
  }
  check_reach(map, file, skin.mesh);
  for (Eigen::Vector3f& n : skin.mesh.normals) {
    n = (hand_from_file.rotation * (meters * n.cast<double>()).normalized()).cast<float>();
  }
  if (map.is_left) {
    for (Triangle& triangle : skin.mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  const std::vector<int> bones = bones_of_file(map, file);
  for (const std::vector<BoneShare>& shares : file.shares) {
    PerBone<double>& weights = skin.weights.emplace_back();
    for (const auto& [bone, weight] : shares) {
      if (bones[bone] < 0) {
        fail(map, file, "bones", "every bone that moves skin",
             fmt::format("\"{}\", which is not mapped,", file.bones[bone]));
      }
      weights[static_cast<std::size_t>(bones[bone])] += weight;
    }
  }
  return skin;
}

std::vector<SkinWeights> four_largest(const std::vector<PerBone<double>>& weights) {
  std::vector<SkinWeights> skin;
  skin.reserve(weights.size());
  for (const PerBone<double>& w : weights) skin.push_back(four_largest(w));
  return skin;
}

}  // namespace graspdb
