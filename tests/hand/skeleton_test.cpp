// SPDX-License-Identifier: MIT
#include "graspdb/hand/skeleton.h"

#include <gtest/gtest.h>

#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

Keypoints keypoints_with(int angle, double value) {
  JointAngles angles = JointAngles::Zero();
  angles[angle] = value;
  return keypoints_in_hand(testing::toy_skeleton(), angles);
}

const Keypoints kFlat = keypoints_in_hand(testing::toy_skeleton(), JointAngles::Zero());

TEST(Skeleton, FlatHandIsStraight) {
  EXPECT_NEAR(hand_length(testing::toy_skeleton()), std::hypot(0.01, 0.09) + 0.085, 1e-9);
  EXPECT_NEAR(kFlat(1, 12), 0.175, 1e-12);
}

TEST(Skeleton, FingerFlexionMovesTheTipTowardsThePalmByTheRightAmount) {
  for (int f = 0; f < kFingerCount; ++f) {
    const Keypoints bent = keypoints_with(finger_angle(f, kPipFlexion), kPi / 2);
    EXPECT_NEAR(bent(2, 8 + 4 * f), -0.045, 1e-12);
    EXPECT_NEAR(bent(1, 8 + 4 * f), 0.130, 1e-12);
  }
}

TEST(Skeleton, FingerAbductionIsPositiveTowardsTheThumb) {
  for (int f = 0; f < kFingerCount; ++f) {
    EXPECT_LT(keypoints_with(finger_angle(f, kMcpAbduction), 0.1)(0, 8 + 4 * f),
              kFlat(0, 8 + 4 * f));
  }
}

TEST(Skeleton, ThumbAbductionIsPalmarAndFlexionSweepsAcrossThePalm) {
  EXPECT_LT(keypoints_with(kThumbCmcAbduction, 0.5)(2, 4), kFlat(2, 4) - 0.01);
  EXPECT_GT(keypoints_with(kThumbCmcFlexion, 0.5)(0, 4), kFlat(0, 4) + 0.01);
}

TEST(Skeleton, ThumbAxialRotationTurnsThePulpToTheFingers) {
  JointAngles angles = JointAngles::Zero();
  const auto pulp = [&] {  // the direction opposite to the nail
    return Eigen::Vector3d(
        -hand_from_bones(testing::toy_skeleton(), angles)[kThumbDistal].rotation.col(2));
  };
  angles[kThumbCmcAbduction] = radians(45);
  const double before = pulp().z();
  angles[kThumbCmcAxial] = radians(40);
  EXPECT_GT(pulp().z(), before);  // from facing the index to facing up, to the fingers' pulps
}

TEST(Skeleton, WristAnglesMoveTheForearmOnly) {
  JointAngles angles = JointAngles::Zero();
  angles[kWristFlexion] = 0.4;
  const auto frames = hand_from_bones(testing::toy_skeleton(), angles);
  // The hand flexes towards its palm, so that seen from the palm the elbow goes palmar as well.
  EXPECT_LT((frames[kForearm] * Eigen::Vector3d(0, -0.2, 0)).z(), -0.05);
  EXPECT_EQ(keypoints_with(kWristFlexion, 0.4), kFlat);
  angles.setZero();
  angles[kWristDeviation] = 0.2;  // radial: the elbow goes radial as well
  EXPECT_LT(
      (hand_from_bones(testing::toy_skeleton(), angles)[kForearm] * Eigen::Vector3d(0, -0.2, 0))
          .x(),
      -0.02);
}

TEST(Skeleton, EveryAngleMovesOnlyItsOwnSubtree) {
  const Skeleton skeleton = testing::toy_skeleton();
  const auto before = hand_from_bones(skeleton, JointAngles::Zero());
  const auto bone_moved_by = [](int angle) -> int {
    if (angle < 2) return kForearm;
    if (angle < 5) return kThumbMetacarpal;
    if (angle < 7) return kThumbProximal;
    if (angle < 8) return kThumbDistal;
    const int part = (angle - 8) % 5;
    return kFirstFingerBone + 4 * ((angle - 8) / 5) + (part < 1 ? 0 : part < 3 ? 1 : part - 1);
  };
  for (int angle = 0; angle < kAngleCount; ++angle) {
    JointAngles angles = JointAngles::Zero();
    angles[angle] = 0.01;
    const auto after = hand_from_bones(skeleton, angles);
    for (int bone = 0; bone < kBoneCount; ++bone) {
      bool below = false;
      for (int b = bone; b >= 0; b = bone_parent(b)) below |= b == bone_moved_by(angle);
      const auto i = static_cast<std::size_t>(bone);
      EXPECT_EQ(below, angle_between(before[i].rotation, after[i].rotation) > 1e-9)
          << angle_info(angle).name << " and " << bone_name(bone);
    }
  }
}

TEST(Skeleton, TheForearmsAxisLiesBehindTheWrist) {
  const Skeleton skeleton = testing::toy_skeleton();
  JointAngles angles = JointAngles::Zero();
  EXPECT_TRUE(forearm_point(skeleton, angles, 0.1).isApprox(Eigen::Vector3d(0, -0.1, 0)));
  angles[kWristFlexion] = 0.5;
  angles[kWristDeviation] = -0.2;
  const RigidTransform forearm = hand_from_bones(skeleton, angles)[kForearm];
  EXPECT_TRUE(forearm_point(skeleton, angles, 0.1).isApprox(forearm * Eigen::Vector3d(0, -0.1, 0)));
}

TEST(Skeleton, JsonReturnsEveryNumberExactly) {
  Skeleton skeleton = testing::toy_skeleton();
  RandomStream random(1);
  for (RigidTransform& frame : skeleton.hand_from_bone_at_zero) {
    frame = {Eigen::Matrix3d::NullaryExpr([&] { return random.normal(); }),
             {random.normal(), 1e-300, 0}};
  }
  const Skeleton back = skeleton_from_json(skeleton_to_json(skeleton), "x");
  for (std::size_t b = 0; b < kBoneCount; ++b) {
    EXPECT_EQ(back.hand_from_bone_at_zero[b].rotation, skeleton.hand_from_bone_at_zero[b].rotation);
    EXPECT_EQ(back.hand_from_bone_at_zero[b].translation,
              skeleton.hand_from_bone_at_zero[b].translation);
  }
  EXPECT_THROW(skeleton_from_json("{}", "x"), Error);
  EXPECT_THROW(skeleton_from_json("[1", "x"), Error);
}

}  // namespace
}  // namespace graspdb
