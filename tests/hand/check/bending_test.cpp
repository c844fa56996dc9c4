// SPDX-License-Identifier: MIT
// Each line on bent skin and on reach passes on the male hand and fails on one that was spoilt.
#include <cmath>

#include "inverted.h"
#include "meeting.h"
#include "poses.h"
#include "reach.h"
#include "spoilt_hands.h"
#include "support/toy_skeleton.h"

namespace graspdb::testing {
namespace {

TEST(HandCheckPoses, TatteredSkinInvertsTrianglesInEveryPose) {
  const Lines lines = check_inverted(with_tattered_skin(finger_bone(0, kMiddle), kPalm));
  for (const char* pose : {"flat", "wrap", "pinch"}) {
    expect_fail(lines, std::string("inverted triangles, ") + pose);
  }
  expect_fail(lines, "inverted triangles, fist");
  expect_fail(lines, "inverted triangles, limits of fingers", " deg");
  expect_fail(lines, "inverted and seen, limits of fingers", " deg");
}

TEST(HandCheckPoses, GoodSkinInvertsFewTrianglesAtTheLimits) {
  const Lines lines = check_inverted(male());
  for (const char* pose : {"flat", "wrap", "pinch", "fist"}) {
    expect_pass(lines, std::string("inverted triangles, ") + pose);
  }
  expect_pass(lines, "inverted triangles, limits of wrist");
  expect_pass(lines, "inverted triangles, limits of fingers");
  expect_pass(lines, "inverted and seen, limits of wrist");
  expect_pass(lines, "inverted and seen, limits of fingers");
}

TEST(HandCheckPoses, TatteredSkinOfThumbAndForearmIsNamedByItsOwnAngles) {
  const Lines thumb = check_inverted(with_tattered_skin(kThumbProximal, kPalm));
  expect_fail(thumb, "inverted triangles, limits of thumb", "thumb_");
  expect_fail(thumb, "inverted and seen, limits of thumb", "thumb_");
  const Lines forearm = check_inverted(with_tattered_skin(kForearm, kPalm));
  expect_fail(forearm, "inverted triangles, limits of wrist", "wrist_");
  expect_fail(forearm, "inverted and seen, limits of wrist", "wrist_");
}

TEST(HandCheckPoses, StretchedSkinGainsVolume) {
  // Fingers and thumb 60 mm further from the palm than their skin was bound.
  Hand hand = with_bones_moved(kThumbProximal, kThumbDistal, {-.09, .06, 0});
  for (int f = 0; f < kFingerCount; ++f) {
    for (const FingerBone part : {kProximal, kMiddle, kDistal}) {
      hand.skeleton.hand_from_bone_at_zero[finger_bone(f, part)].translation.y() += .06;
    }
  }
  const Lines good = check_poses(male()), stretched = check_poses(hand);
  for (const char* pose : {"flat", "wrap", "pinch", "fist", "limits of thumb"}) {
    expect_fail(stretched, std::string("volume change, ") + pose);
    expect_pass(good, std::string("volume change, ") + pose);
  }
  expect_fail(stretched, "volume change, limits of thumb", "thumb_");
}

TEST(HandCheckPoses, SkinThatIsBoundFlatIsPinchedAtAFlexedPip) {
  const Lines good = check_poses(male()), flat = check_poses(bound_flat());
  for (const char* finger : {"index", "middle", "ring", "little"}) {
    const std::string name = std::string("PIP section, ") + finger;
    expect_pass(good, name);
    expect_fail(flat, name, "mm");
    EXPECT_NEAR(line_of(flat, name).value, 60, 12);  // a first model of this kind kept 59 %
  }
}

TEST(HandCheckPoses, APipJointOutsideItsSkinFails) {
  Hand hand = male();
  for (RigidTransform* frame : {&hand.skeleton.hand_from_bone_at_zero[finger_bone(1, kMiddle)],
                                &hand.hand_from_bone_at_bind[finger_bone(1, kMiddle)]}) {
    frame->translation += .05 * frame->rotation.col(2);
  }
  expect_fail(check_poses(hand), "PIP section, middle", "not lie in its skin");
}

TEST(HandCheckReach, PassesOnAGoodHandAndTwiceTheSame) {
  const Lines lines = check_reach(male()), again = check_reach(male());
  ASSERT_EQ(lines.size(), 12);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].status, Status::kPass) << lines[i].name << " " << lines[i].value;
    EXPECT_EQ(lines[i].value, again[i].value) << lines[i].name;
  }
}

TEST(HandCheckReach, BestMeetingIsBetterThanAnyOfManyPoses) {
  const Skeleton skeleton = toy_skeleton();
  const DigitPulp thumb{0, {0, .02, -.009}}, little{4, {0, .013, -.008}};
  const Meeting best = best_meeting(skeleton, thumb, little);
  RandomStream random(9);
  double least = 1e9;
  for (int i = 0; i < 20000; ++i) {
    JointAngles angles;
    for (int a = 0; a < kAngleCount; ++a) {
      angles[a] = random.uniform(angle_info(a).lower, angle_info(a).upper);
    }
    const PerBone<RigidTransform> frames = hand_from_bones(skeleton, clamp_to_range(angles));
    const RigidTransform &a = frames[kThumbDistal], &b = frames[finger_bone(3, kDistal)];
    const double gap = (a * thumb.in_distal - b * little.in_distal).norm();
    const double facing = std::acos(-a.rotation.col(2).dot(b.rotation.col(2)));
    least = std::min(least, Meeting{gap, facing}.badness());
  }
  EXPECT_LT(best.badness(), least);
  EXPECT_LT(best.badness(), 1);
}

TEST(HandCheckReach, AThumbOnTheElbowsSideReachesNoFinger) {
  const Lines lines =
      check_reach(with_bones_moved(kThumbMetacarpal, kThumbDistal, {-.02, -.15, 0}));
  for (const char* finger : {"index", "middle", "ring", "little"}) {
    expect_fail(lines, std::string("pulp gap, ") + finger);
  }
}

TEST(HandCheckReach, ANailThatLooksDorsallyTurnsTheThumbFromTheFingers) {
  const Lines lines = check_reach(with_bones_rolled(kThumbMetacarpal, kThumbDistal, radians(90)));
  for (const char* finger : {"index", "middle", "ring", "little"}) {
    expect_fail(lines, std::string("pulp facing, ") + finger);
  }
  expect_fail(lines, "pulp gap, little");
  expect_pass(lines, "pulp gap, index");
}

TEST(HandCheckReach, ATipWithoutPalmarSkinFails) {
  Hand hand = male();
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const int index = finger_bone(0, kDistal);
  const RigidTransform bone_from_hand = hand.hand_from_bone_at_bind[index].inverse();
  for (std::size_t v = 0; v < bones.size(); ++v) {
    const Eigen::Vector3d place = bone_from_hand * hand.bind_mesh.vertices[v].cast<double>();
    if (bones[v] == index && place.z() < 0) hand.weights[v] = only(finger_bone(0, kMiddle));
  }
  expect_fail(check_reach(hand), "pulp gap, index", "palmar");
  expect_fail(check_reach(hand), "pulp facing, index", "palmar");
}

TEST(HandCheckReach, AKnuckleTooFarOutKeepsTheTipFromThePalm) {
  const Lines lines = check_reach(
      with_bones_moved(finger_bone(2, kProximal), finger_bone(2, kDistal), {0, .02, -.01}));
  expect_fail(lines, "tip to palm, ring");
  expect_pass(lines, "tip to palm, index");
}

}  // namespace
}  // namespace graspdb::testing
