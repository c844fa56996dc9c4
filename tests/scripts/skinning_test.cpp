// SPDX-License-Identifier: MIT
// Our skinning of the committed hands against Blender's, which reads the same files on its own.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "blender.h"
#include "graspdb/core/file.h"
#include "graspdb/hand/named_poses.h"
#include "graspdb/hand/rig/rig.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using nlohmann::json;

// What takes a joint of the file to its place in the pose. The files of our own hands have their
// joints in the hand frame, under the names of the bones.
json moved_from_rest(const Hand& hand, const PerBone<RigidTransform>& hand_from_bone) {
  json bones = json::object();
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const RigidTransform moved = hand_from_bone[bone] * hand.hand_from_bone_at_bind[bone].inverse();
    json& rows = bones[std::string(bone_name(static_cast<int>(bone)))];
    for (int row = 0; row < 3; ++row) {
      const auto r = moved.rotation.row(row);
      rows.push_back({r[0], r[1], r[2], moved.translation[row]});
    }
  }
  return bones;
}

json posed(const Hand& hand, std::string_view name, const JointAngles& angles) {
  const PerBone<RigidTransform> hand_from_bone = hand_from_bones(hand.skeleton, angles);
  json vertices = json::array();
  for (const Eigen::Vector3f& v : pose_skin(hand, hand_from_bone).vertices) {
    vertices.push_back({v.x(), v.y(), v.z()});
  }
  return {{"name", name},
          {"bones", moved_from_rest(hand, hand_from_bone)},
          {"vertices", std::move(vertices)}};
}

// The named poses keep the wrist straight.
JointAngles upper_limits() {
  JointAngles angles;
  for (int i = 0; i < kAngleCount; ++i) angles[i] = angle_info(i).upper;
  return clamp_to_range(angles);
}

class Skinning : public ::testing::TestWithParam<const char*> {};

TEST_P(Skinning, AgreesWithBlenderWithinAMicrometer) {
  if (!testing::has_blender()) GTEST_SKIP() << testing::kNoBlender;
  const std::string file = std::string(GRASPDB_SOURCE_DIR "/assets/hands/") + GetParam() + ".glb";
  const Hand hand = load_hand(file);
  json poses = json::array();
  for (const std::string_view name : kNamedPoses) {
    poses.push_back(posed(hand, name, named_pose(name)));
  }
  poses.push_back(posed(hand, "upper_limits", upper_limits()));
  const testing::TemporaryDirectory folder;
  write_text(folder / "poses.json", poses.dump());
  const testing::BlenderOutcome outcome = testing::run_blender(
      "", "scripts/blender/check_skinning.py",
      {file, (folder / "poses.json").string(), (folder / "differences.json").string()});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const json differences_mm = json::parse(read_text(folder / "differences.json"));
  ASSERT_EQ(differences_mm.size(), poses.size());
  for (const auto& [pose, difference_mm] : differences_mm.items()) {
    EXPECT_LT(difference_mm.get<double>(), .001) << pose;
    RecordProperty(pose + "_nm", std::to_string(1e6 * difference_mm.get<double>()));
  }
}

constexpr auto kHandName = [](const auto& info) { return info.param; };
INSTANTIATE_TEST_SUITE_P(Hands, Skinning, ::testing::Values("male", "female", "slender", "child"),
                         kHandName);

}  // namespace
}  // namespace graspdb
