// SPDX-License-Identifier: MIT
// Size and angles, hands that lack a part, and the check as a whole.
#include <cmath>

#include "angles.h"
#include "graspdb/hand/check/hand_check.h"
#include "inverted.h"
#include "poses.h"
#include "reach.h"
#include "size.h"
#include "spoilt_hands.h"

namespace graspdb::testing {
namespace {

using ::testing::HasSubstr;

TEST(HandCheckSize, IsHeldToWhatWasAskedFor) {
  const AskedSize asked{193, 88};
  for (const char* name : {"hand length", "hand breadth"}) {
    expect_pass(check_size(male(), asked), name);
    expect_fail(check_size(scaled(1.03), asked), name);
    expect_fail(check_size(scaled(.97), asked), name);
    expect_not_applicable(check_size(male(), std::nullopt), name, "not known");
    EXPECT_GT(line_of(check_size(male(), std::nullopt), name).value, 80);
  }
}

TEST(HandCheckAngles, PassesOnAGoodHand) {
  for (const HandCheckLine& line : check_angles(male())) {
    EXPECT_EQ(line.status, Status::kPass) << line.name << " " << line.value << " " << line.why;
  }
}

TEST(HandCheckAngles, SkinOnTheNeighborsBoneFollowsTheWrongFinger) {
  Hand hand = male();
  for (SkinWeights& skin : hand.weights) {
    for (std::uint8_t& bone : skin.bone) {
      if (bone == finger_bone(1, kDistal))
        bone = finger_bone(2, kDistal);
      else if (bone == finger_bone(2, kDistal))
        bone = finger_bone(1, kDistal);
    }
  }
  expect_fail(check_angles(hand), "skin follows, digits", "_flexion, vertex");
}

TEST(HandCheckAngles, OneVertexOnAWrongBoneIsFound) {
  Hand hand = male();
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const int little_distal = finger_bone(3, kDistal);
  const auto vertex = static_cast<std::size_t>(
      std::find(bones.begin(), bones.end(), little_distal) - bones.begin());
  hand.weights[vertex] = only(finger_bone(0, kDistal));
  expect_fail(check_angles(hand), "skin follows, digits", "vertex " + std::to_string(vertex));
}

TEST(HandCheckAngles, ForearmAndMetacarpalsSwappedIsFound) {
  expect_fail(check_angles(with_tattered_skin(kForearm, kPalm)), "skin follows, wrist", "wrist_");
  expect_fail(check_angles(with_tattered_skin(finger_bone(3, kMetacarpal), kThumbMetacarpal)),
              "skin follows, CMC joints", "cmc");
}

TEST(HandCheckAngles, JointsThatBendTheOtherWayAreNamed) {
  const int index = finger_bone(0, kProximal);
  expect_fail(check_angles(with_bones_rolled(index, index + 2, kPi)), "direction, fingers",
              "index_");
  expect_fail(check_angles(with_bones_rolled(kForearm, kForearm, kPi)), "direction, wrist",
              "wrist_");
  expect_fail(check_angles(with_bones_rolled(kThumbMetacarpal, kThumbDistal, kPi)),
              "direction, thumb", "thumb_");
}

TEST(HandCheckAngles, AnAxisThatIsSwappedWithAnotherIsNamed) {
  // A quarter turn: flexion goes sideways.
  const int little = finger_bone(3, kProximal);
  expect_fail(check_angles(with_bones_rolled(little, little + 2, kPi / 2)), "direction, fingers",
              "little_");
  expect_fail(check_angles(with_bones_rolled(kThumbMetacarpal, kThumbDistal, kPi / 2)),
              "direction, thumb", "thumb_");
}

TEST(HandCheckAngles, AThumbThatTurnsItsPulpAwayIsNamed) {
  // The thumb points to the elbow: its axial angle turns the other way round.
  Hand hand = male();
  for (const int bone : {kThumbMetacarpal, kThumbProximal, kThumbDistal}) {
    for (PerBone<RigidTransform>* frames :
         {&hand.skeleton.hand_from_bone_at_zero, &hand.hand_from_bone_at_bind}) {
      Eigen::Matrix3d& rotation = (*frames)[static_cast<std::size_t>(bone)].rotation;
      rotation = rotation * axis_rotation(2, kPi);
    }
  }
  expect_fail(check_angles(hand), "direction, thumb", "thumb_");
}

TEST(HandCheckMissing, WithoutAForearmTheWristIsNotApplicable) {
  const Hand hand = with_skin_of_given_to(kForearm, kPalm);
  const std::string why = "forearm moves no skin";
  const Lines inverted = check_inverted(hand), angles = check_angles(hand);
  expect_not_applicable(inverted, "inverted triangles, limits of wrist", why);
  expect_not_applicable(inverted, "inverted and seen, limits of wrist", why);
  expect_not_applicable(angles, "skin follows, wrist", why);
  expect_not_applicable(angles, "direction, wrist", why);
  expect_pass(angles, "direction, thumb");
}

TEST(HandCheckMissing, WithoutSkinOnATipItsLinesAreNotApplicable) {
  const Hand hand = with_skin_of_given_to(finger_bone(1, kDistal), finger_bone(1, kMiddle));
  const std::string why = "middle_distal moves no skin";
  const Lines reach = check_reach(hand);
  expect_not_applicable(reach, "pulp gap, middle", why);
  expect_not_applicable(reach, "pulp facing, middle", why);
  expect_not_applicable(reach, "tip to palm, middle", why);
  expect_pass(reach, "pulp gap, index");
  expect_not_applicable(check_size(hand, AskedSize{193, 88}), "hand length", why);
  expect_not_applicable(check_angles(hand), "direction, fingers", why);
  expect_not_applicable(check_angles(hand), "skin follows, digits", why);
  expect_not_applicable(
      check_poses(with_skin_of_given_to(finger_bone(1, kMiddle), finger_bone(1, kDistal))),
      "PIP section, middle", "middle_middle moves no skin");
}

TEST(HandCheckMissing, AFaultElsewhereStillFails) {
  Hand hand = with_skin_of_given_to(finger_bone(1, kDistal), finger_bone(1, kMiddle));
  const Hand rolled = with_bones_rolled(finger_bone(0, kProximal), finger_bone(0, kDistal), kPi);
  hand.skeleton = rolled.skeleton;
  hand.hand_from_bone_at_bind = rolled.hand_from_bone_at_bind;
  expect_fail(check_angles(hand), "direction, fingers", "index_");
}

TEST(HandCheck, NamesAndOrderOfLinesAreTheSameForEveryHand) {
  const Lines good = check_hand(male());
  const Lines poor = check_hand(with_skin_of_given_to(kForearm, kPalm), AskedSize{193, 88});
  ASSERT_EQ(good.size(), poor.size());
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_EQ(good[i].name, poor[i].name);
    EXPECT_EQ(good[i].unit, poor[i].unit);
  }
  EXPECT_TRUE(std::all_of(good.begin(), good.end(),
                          [](const auto& line) { return !std::isnan(line.value); }));
}

TEST(HandCheck, PassesWhenNoLineFails) {
  const HandCheckLine pass{"a", 1, "", "", Status::kPass, ""};
  HandCheckLine fail = pass, missing = pass;
  fail.status = Status::kFail;
  missing.status = Status::kNotApplicable;
  EXPECT_TRUE(passes(Lines{pass, missing}));
  EXPECT_FALSE(passes(Lines{pass, fail}));
}

TEST(HandCheck, AHandMadeAgainIsComparedToAMicrometer) {
  Hand other = male();
  EXPECT_EQ(check_made_again(male(), other).status, Status::kPass);
  EXPECT_EQ(check_made_again(male(), std::nullopt).status, Status::kNotApplicable);
  other.bind_mesh.vertices[7].x() += 2e-6f;
  EXPECT_EQ(check_made_again(male(), other).status, Status::kFail);
  EXPECT_NEAR(check_made_again(male(), other).value, 2e-6, 1e-8);
  other = male();
  other.weights[9].weight[0] -= 1e-5f;
  EXPECT_EQ(check_made_again(male(), other).status, Status::kFail);
  other = male();
  other.skeleton.tip_in_distal[4].y() += 1e-5;
  EXPECT_EQ(check_made_again(male(), other).status, Status::kFail);
  other = male();
  other.bind_mesh.triangles.pop_back();
  EXPECT_EQ(check_made_again(male(), other).status, Status::kFail);
  EXPECT_THAT(check_made_again(male(), other).why, HasSubstr("triangles"));
}

}  // namespace
}  // namespace graspdb::testing
