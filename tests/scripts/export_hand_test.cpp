// SPDX-License-Identifier: MIT
// From a .blend as others have it to a hand of graspdb: the exported file with its filled-in draft
// is the hand that the .blend was made of.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blender.h"
#include "graspdb/core/file.h"
#include "graspdb/core/toml.h"
#include "graspdb/hand/named_poses.h"
#include "graspdb/hand/rig/rig.h"
#include "support/compare_hands.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::BlenderOutcome;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_blender;

const std::filesystem::path kMale = GRASPDB_SOURCE_DIR "/assets/hands/male.glb";
constexpr const char* kSideToFillIn = "# fill in: handedness = \"right\" or \"left\"";

std::string nail_of(const Eigen::Vector3d& nail) {
  return fmt::format("{:.9f},{:.9f},{:.9f}", nail.x(), nail.y(), nail.z());
}

class ExportHand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::has_blender()) GTEST_SKIP() << testing::kNoBlender;
    const std::vector<double> nail =
        TomlTable::load(rig_map_beside(kMale)).numbers("thumb_nail", 3, -1, 1);
    nail_ = {nail[0], nail[1], nail[2]};
  }

  // The scene that make_foreign_hand.py makes.
  void make_scene(const std::string& kind) {
    const BlenderOutcome made =
        run_blender("", "tests/scripts/make_foreign_hand.py",
                    {kMale.string(), scene().string(), kind, nail_of(nail_)});
    ASSERT_EQ(made.code, 0) << made.output;
  }

  BlenderOutcome export_hand(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"hand", glb().string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_blender(scene(), "scripts/blender/export_for_graspdb.py", arguments);
  }

  std::filesystem::path scene() const { return folder_ / "scene.blend"; }
  std::filesystem::path glb() const { return folder_ / "foreign.glb"; }

  testing::TemporaryDirectory folder_;
  Eigen::Vector3d nail_;  // in the male hand's file
  const Hand male_ = load_hand(kMale);
};

// Within 0.01 mm, at zero, at rest, and of the skin in a fist.
void expect_same_joints_and_skin(const Hand& hand, const Hand& expected) {
  EXPECT_LT(testing::largest_difference(hand.skeleton, expected.skeleton), 1e-5);
  EXPECT_LT((keypoints_in_hand(hand.skeleton, hand.hand_from_bone_at_bind) -
             keypoints_in_hand(expected.skeleton, expected.hand_from_bone_at_bind))
                .cwiseAbs()
                .maxCoeff(),
            1e-5);
  const JointAngles& fist = named_pose("fist");
  EXPECT_LT(testing::largest_difference(pose_skin(hand, fist), pose_skin(expected, fist)), 1e-5);
}

TEST_F(ExportHand, KeepsAMapThatAPersonMayHaveFilledIn) {
  make_scene("left");
  write_text(rig_map_beside(glb()), "filled in");
  ASSERT_EQ(export_hand({"--nail=1,0,0"}).code, 0);
  EXPECT_EQ(read_text(rig_map_beside(glb())), "filled in");
  EXPECT_THAT(read_text(folder_ / "foreign.draft.rig.toml"), HasSubstr("[bones]"));
}

TEST_F(ExportHand, LeftHandInCentimetersUnderForeignNamesIsTheSameHand) {
  make_scene("left");
  // The same nail in Blender's axes, on a left hand.
  const BlenderOutcome outcome =
      export_hand({"--nail=" + nail_of({-nail_.x(), -nail_.z(), nail_.y()})});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  const std::string draft = read_text(rig_map_beside(glb()));
  EXPECT_THAT(draft, Not(HasSubstr("fill in")));
  EXPECT_THAT(draft, HasSubstr("#   ik_hand_l"));
  expect_same_joints_and_skin(load_hand(glb()), male_);
}

TEST_F(ExportHand, TurnedAndScaledHandWithItsNailSelectedIsTheSameHand) {
  make_scene("turned");
  const BlenderOutcome outcome = export_hand({"--nail", "selected"});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  std::string draft = read_text(rig_map_beside(glb()));
  const auto to_fill_in = draft.find(kSideToFillIn);
  ASSERT_NE(to_fill_in, std::string::npos) << draft;
  draft.replace(to_fill_in, std::string(kSideToFillIn).size(), "handedness = \"right\"");
  write_text(rig_map_beside(glb()), draft);
  const Hand hand = load_hand(glb());
  EXPECT_LT(testing::largest_difference(hand.skeleton, male_.skeleton), 1e-5);
  EXPECT_LT(testing::largest_difference(hand.bind_mesh, male_.bind_mesh), 1e-5);
  EXPECT_LT(angle_between(hand.hand_from_bone_at_bind[kThumbDistal].rotation,
                          male_.hand_from_bone_at_bind[kThumbDistal].rotation),
            radians(10));  // a nail is not flat
}

}  // namespace
}  // namespace graspdb
