// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "graspdb/core/error.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {
namespace {

using nlohmann::json;

json to_json(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Eigen::Vector3d vector_from_json(const json& value) {
  if (value.size() != 3) throw json::other_error::create(501, "a vector needs 3 numbers", nullptr);
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

}  // namespace

std::string skeleton_to_json(const Skeleton& skeleton) {
  json bones = json::object();
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const RigidTransform& frame = skeleton.hand_from_bone_at_zero[static_cast<std::size_t>(bone)];
    json rotation = json::array();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) rotation.push_back(frame.rotation(row, column));
    }
    bones[std::string(bone_name(bone))] = {{"origin_m", to_json(frame.translation)},
                                           {"rotation", std::move(rotation)}};
  }
  json tips = json::array();
  for (const Eigen::Vector3d& tip : skeleton.tip_in_distal) tips.push_back(to_json(tip));
  return json{{"palm_from_bone_at_zero", bones}, {"tip_in_distal_m", tips}}.dump();
}

Skeleton skeleton_from_json(std::string_view text, const std::string& file) {
  try {
    const json value = json::parse(text);
    Skeleton skeleton;
    for (int bone = 0; bone < kBoneCount; ++bone) {
      const json& entry = value.at("palm_from_bone_at_zero").at(std::string(bone_name(bone)));
      RigidTransform& frame = skeleton.hand_from_bone_at_zero[static_cast<std::size_t>(bone)];
      frame.translation = vector_from_json(entry.at("origin_m"));
      for (std::size_t i = 0; i < 9; ++i) {
        frame.rotation(static_cast<int>(i / 3), static_cast<int>(i % 3)) =
            entry.at("rotation").at(i).get<double>();
      }
    }
    for (std::size_t tip = 0; tip < 5; ++tip) {
      skeleton.tip_in_distal[tip] = vector_from_json(value.at("tip_in_distal_m").at(tip));
    }
    return skeleton;
  } catch (const json::exception& fault) {
    throw Error({.file = file,
                 .key = "skeleton",
                 .expected = "21 bones and 5 tips",
                 .found = fault.what()});
  }
}

}  // namespace graspdb
