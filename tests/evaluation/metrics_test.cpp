// SPDX-License-Identifier: MIT
#include "graspdb/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/transform.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

Pose pose_with(const Eigen::Matrix3d& rotation, const JointAngles& angles) {
  return {rotation, angles, rotation * keypoints_in_palm(testing::toy_skeleton(), angles)};
}

const Pose kFlat = pose_with(Eigen::Matrix3d::Identity(), JointAngles::Zero());

TEST(Metrics, ThePoseItselfHasNoError) {
  const FrameErrors none = compare(kFlat, kFlat);
  EXPECT_EQ(none.pose, 0);
  EXPECT_EQ(none.rotation_deg, 0);
  EXPECT_EQ(none.joint_deg, 0);
  EXPECT_EQ(none.mpjpe_mm, 0);
  EXPECT_NEAR(none.pa_mpjpe_mm, 0, 1e-9);
}

TEST(Metrics, ATurnOf20DegreesIsHalfAUnitOfThePapersError) {
  const Pose turned = pose_with(axis_rotation(1, radians(20)), JointAngles::Zero());
  const FrameErrors errors = compare(turned, kFlat);
  EXPECT_NEAR(errors.rotation_deg, 20, 1e-9);
  EXPECT_NEAR(errors.pose, 2 * std::sqrt(2.0) * std::sin(radians(10)), 1e-12);
  EXPECT_EQ(errors.joint_deg, 0);
  EXPECT_GT(errors.mpjpe_mm, 1);
  EXPECT_NEAR(errors.pa_mpjpe_mm, 0, 1e-9);  // a turn is aligned away
}

TEST(Metrics, JointErrorIsTheMeanOverFingersAndThumb) {
  JointAngles angles = JointAngles::Zero();
  angles[finger_angle(1, kPipFlexion)] = radians(26);
  angles[kWristFlexion] = radians(40);  // the wrist does not count
  EXPECT_NEAR(mean_joint_difference_deg(angles, JointAngles::Zero()), 1, 1e-12);
}

TEST(Metrics, ASineFoldsBackBut120DegreesAreFurtherThan60InDegrees) {
  JointAngles sixty = JointAngles::Zero(), folded = JointAngles::Zero();
  sixty[finger_angle(0, kPipFlexion)] = radians(60);
  folded[finger_angle(0, kPipFlexion)] = radians(120);
  const FrameErrors errors = compare(pose_with(Eigen::Matrix3d::Identity(), sixty),
                                     pose_with(Eigen::Matrix3d::Identity(), folded));
  EXPECT_NEAR(errors.pose, 0, 1e-12);
  EXPECT_NEAR(errors.joint_deg, 60.0 / 26, 1e-9);
}

TEST(Metrics, MpjpeIgnoresWhereTheWristIs) {
  Keypoints moved = kFlat.joints;
  moved.colwise() += Eigen::Vector3d(1, 2, 3);
  EXPECT_NEAR(mpjpe_mm(moved, kFlat.joints), 0, 1e-9);
  moved.col(4).x() += 0.021;
  EXPECT_NEAR(mpjpe_mm(moved, kFlat.joints), 1, 1e-9);
}

TEST(Metrics, ProcrustesTakesScaleAwayButNotAMirror) {
  EXPECT_NEAR(pa_mpjpe_mm(kFlat.joints * 1.3, kFlat.joints), 0, 1e-9);
  Keypoints bent = pose_with(Eigen::Matrix3d::Identity(), JointAngles::Constant(0.3)).joints;
  Keypoints mirrored = bent;
  mirrored.row(0) *= -1;
  EXPECT_GT(pa_mpjpe_mm(mirrored, bent), 1);
}

TEST(Metrics, SpreadKnowsMeanMedianAndNinetiethPercentile) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(100 - i);
  const Spread s = spread(values);
  EXPECT_DOUBLE_EQ(s.mean, 50);
  EXPECT_DOUBLE_EQ(s.median, 50);
  EXPECT_DOUBLE_EQ(s.p90, 90);
  EXPECT_TRUE(std::isnan(spread({}).mean));
}

TEST(Metrics, FlipsAreTurnsBeyond90Degrees) {
  std::vector<FrameErrors> frames(4);
  frames[0].rotation_deg = 91;
  frames[1].rotation_deg = 89;
  EXPECT_DOUBLE_EQ(summarize(frames).flips, 0.25);
  EXPECT_TRUE(std::isnan(summarize({}).flips));
  EXPECT_TRUE(std::isnan(summarize({}).pose_error));
}

}  // namespace
}  // namespace graspdb
