// SPDX-License-Identifier: MIT
#include <algorithm>

#include "graspdb/core/json/json_numbers.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr const char* kBones = "palm_from_bone_at_zero";
constexpr const char* kTips = "tip_in_distal_m";

}  // namespace

std::string skeleton_to_json(const Skeleton& skeleton) {
  json bones = json::object();
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const RigidTransform& frame = skeleton.hand_from_bone_at_zero[static_cast<std::size_t>(bone)];
    bones[std::string(bone_name(bone))] = {{"origin_m", numbers(frame.translation)},
                                           {"rotation", numbers(frame.rotation)}};
  }
  json tips = json::array();
  for (const Eigen::Vector3d& tip : skeleton.tip_in_distal) tips.push_back(numbers(tip));
  return json{{kBones, bones}, {kTips, tips}}.dump();
}

Skeleton skeleton_from_json(std::string_view text, const std::string& file) {
  const json root = parse_strict_json(text, file, "skeleton");
  const JsonFields fields(root, file, "skeleton");
  const JsonFields bones = fields.fields(kBones);
  Skeleton skeleton;
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const JsonFields entry = bones.fields(std::string(bone_name(bone)));
    skeleton.hand_from_bone_at_zero[static_cast<std::size_t>(bone)] = {
        entry.matrix<Eigen::Matrix3d>("rotation"), entry.matrix<Eigen::Vector3d>("origin_m")};
  }
  const auto tips = fields.points(kTips, skeleton.tip_in_distal.size());
  std::ranges::copy(tips, skeleton.tip_in_distal.begin());
  return skeleton;
}

}  // namespace graspdb
