// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "graspdb/core/transform.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

constexpr Intrinsics kCamera{
    .width = 640, .height = 480, .fx = 500, .fy = 500, .cx = 319.5, .cy = 239.5};

Pose pose_with(const Eigen::Matrix3d& rotation, const JointAngles& angles) {
  Keypoints joints = rotation * keypoints_in_hand(testing::toy_skeleton(), angles);
  joints.row(2).array() += 0.5;
  return {rotation, angles, joints};
}

const Pose kFlat = pose_with(Eigen::Matrix3d::Identity(), JointAngles::Zero());

FrameErrors errors_of(const Pose& estimate, const Pose& truth = kFlat) {
  return compare({estimate, {}}, {truth, kCamera, {}});
}

Pose bent(int angle, double by_deg) {
  JointAngles angles = JointAngles::Zero();
  angles[angle] = radians(by_deg);
  return pose_with(Eigen::Matrix3d::Identity(), angles);
}

Pose moved(const Eigen::Vector3d& by) {
  Pose pose = kFlat;
  pose.joints.colwise() += by;
  return pose;
}

TEST(Metrics, EachHasItsOwnName) {
  std::set<std::string_view> names;
  for (int m = 0; m < kRunMetricCount; ++m) names.insert(metric_info(m).name);
  EXPECT_EQ(names.size(), std::size_t{kRunMetricCount});
  EXPECT_EQ(names.count(""), 0U);
}

TEST(Metrics, ThePoseItselfHasNoError) {
  const FrameErrors errors = errors_of(kFlat);
  for (int m = 0; m <= kError2dPalms; ++m)
    EXPECT_NEAR(errors[static_cast<std::size_t>(m)], 0, 1e-9) << metric_info(m).name;
  for (int m = kGraspTop1; m <= kGrasp17Top5; ++m)
    EXPECT_TRUE(std::isnan(errors[static_cast<std::size_t>(m)])) << metric_info(m).name;
}

TEST(Metrics, ATurnOf20DegreesIsHalfAUnitOfThePapersError) {
  const Pose turned = pose_with(axis_rotation(1, radians(20)), JointAngles::Zero());
  const FrameErrors errors = errors_of(turned);
  EXPECT_NEAR(errors[kRotationDeg], 20, 1e-9);
  EXPECT_NEAR(errors[kPoseError], 2 * std::sqrt(2.0) * std::sin(radians(10)), 1e-12);
  EXPECT_EQ(errors[kJointDeg], 0);
  EXPECT_GT(errors[kMpjpeMm], 1);
  EXPECT_NEAR(errors[kPaMpjpeMm], 0, 1e-9);  // a turn is aligned away
}

TEST(Metrics, FlipsAreTurnsBeyond90Degrees) {
  EXPECT_EQ(errors_of(pose_with(axis_rotation(1, radians(91)), JointAngles::Zero()))[kFlips], 1);
  EXPECT_EQ(errors_of(pose_with(axis_rotation(1, radians(89)), JointAngles::Zero()))[kFlips], 0);
}

TEST(Metrics, JointErrorIsTheMeanOverFingersAndThumb) {
  EXPECT_NEAR(errors_of(bent(finger_angle(1, kPipFlexion), 26))[kJointDeg], 1, 1e-12);
  EXPECT_EQ(errors_of(bent(kWristFlexion, 40))[kJointDeg], 0);  // the wrist is no finger
}

TEST(Metrics, EachClassOfJointsSeesItsOwnOnly) {
  const auto expect = [](int angle, double mcp, double pip, double dip, double thumb) {
    const FrameErrors errors = errors_of(bent(angle, -12));
    EXPECT_NEAR(errors[kMcpDeg], mcp, 1e-9);
    EXPECT_NEAR(errors[kPipDeg], pip, 1e-9);
    EXPECT_NEAR(errors[kDipDeg], dip, 1e-9);
    EXPECT_NEAR(errors[kThumbDeg], thumb, 1e-9);
  };
  expect(finger_angle(0, kMcpFlexion), 3, 0, 0, 0);  // one of four fingers
  expect(finger_angle(3, kPipFlexion), 0, 3, 0, 0);
  expect(finger_angle(2, kDipFlexion), 0, 0, 3, 0);
  expect(kThumbCmcFlexion, 0, 0, 0, 2);  // one of six angles
  expect(kThumbIpFlexion, 0, 0, 0, 2);
  expect(finger_angle(0, kCmcFlexion), 0, 0, 0, 0);
  expect(finger_angle(0, kMcpAbduction), 0, 0, 0, 0);
}

TEST(Metrics, ASineFoldsBackBut120DegreesAreFurtherThan60InDegrees) {
  const FrameErrors errors =
      errors_of(bent(finger_angle(0, kPipFlexion), 60), bent(finger_angle(0, kPipFlexion), 120));
  EXPECT_NEAR(errors[kPoseError], 0, 1e-12);
  EXPECT_NEAR(errors[kJointDeg], 60.0 / 26, 1e-9);
  EXPECT_NEAR(errors[kPipDeg], 15, 1e-9);
}

TEST(Metrics, MpjpeIgnoresWhereTheWristIs) {
  Pose pose = moved({1, 2, 3});
  EXPECT_NEAR(errors_of(pose)[kMpjpeMm], 0, 1e-9);
  pose.joints.col(4).x() += 0.021;
  EXPECT_NEAR(errors_of(pose)[kMpjpeMm], 1, 1e-9);
}

TEST(Metrics, ScaleIsNormalizedAwayButNotATurn) {
  Pose larger = kFlat;
  larger.joints = 1.3 * (kFlat.joints.colwise() - kFlat.joints.col(0));
  EXPECT_NEAR(errors_of(larger)[kSnMpjpeMm], 0, 1e-9);
  EXPECT_GT(errors_of(larger)[kMpjpeMm], 10);
  EXPECT_NEAR(best_scale(larger.joints, kFlat.joints), 1 / 1.3, 1e-12);
  // At a right angle no length of the wrong direction is any use: what is left is the hand itself.
  Keypoints along_x = Keypoints::Zero(), along_y = Keypoints::Zero();
  along_x(0, 8) = along_y(1, 8) = 0.21;
  EXPECT_NEAR(sn_mpjpe_mm(along_x, along_y), 10, 1e-9);
  EXPECT_EQ(best_scale(-along_x, along_x), 0);  // never a mirrored hand
}

TEST(Metrics, ProcrustesTakesScaleAwayButNotAMirror) {
  EXPECT_NEAR(pa_mpjpe_mm(kFlat.joints * 1.3, kFlat.joints), 0, 1e-9);
  const Keypoints curled =
      pose_with(Eigen::Matrix3d::Identity(), JointAngles::Constant(0.3)).joints;
  Keypoints mirrored = curled;
  mirrored.row(0) *= -1;
  EXPECT_GT(pa_mpjpe_mm(mirrored, curled), 1);
}

TEST(Metrics, TheFlatErrorIsInPalmLengthsWhateverTheCamera) {
  // All of the flat hand is as far away as its wrist.
  Pose flat = kFlat;
  flat.joints.row(2).setConstant(0.5);
  const double palm = (flat.joints.col(9) - flat.joints.col(0)).norm();
  Pose aside = flat;
  aside.joints.row(0).array() += palm / 2;
  for (const double focal : {250.0, 800.0}) {
    Intrinsics camera = kCamera;
    camera.fx = camera.fy = focal;
    EXPECT_NEAR(error_2d_palms(aside.joints, flat.joints, camera), 0.5, 1e-9);
  }
  // Twice as far along the rays: the same picture.
  EXPECT_NEAR(error_2d_palms(2 * aside.joints, aside.joints, kCamera), 0, 1e-9);
}

TEST(Metrics, JointsBehindTheCameraHaveNoFlatError) {
  EXPECT_TRUE(std::isnan(errors_of(moved({0, 0, -0.6}))[kError2dPalms]));
}

TEST(GraspMetrics, TypesAreRankedByWeightAndClassesByTheirSum) {
  const GraspWeights weights = {{1, 0.2}, {2, 0.2}, {9, 0.3}, {14, 0.15}, {16, 0.1}, {20, 0.05}};
  const auto found = [&](int type) { return compare({kFlat, weights}, {kFlat, kCamera, type}); };
  EXPECT_EQ(found(9)[kGraspTop1], 1);
  EXPECT_EQ(found(1)[kGraspTop1], 0);
  EXPECT_EQ(found(1)[kGrasp17Top1], 1);  // with 2 it outweighs 9
  EXPECT_EQ(found(3)[kGrasp17Top1], 1);  // never named, but of that class
  EXPECT_EQ(found(3)[kGraspTop5], 0);
  EXPECT_EQ(found(16)[kGraspTop5], 1);
  EXPECT_EQ(found(20)[kGraspTop5], 0);    // the sixth
  EXPECT_EQ(found(20)[kGrasp17Top5], 1);  // the fifth class
  EXPECT_EQ(found(33)[kGrasp17Top5], 1);  // as 9
}

TEST(GraspMetrics, TiesGoToTheSmallerNumber) {
  const GraspWeights even = {{4, 0.5}, {7, 0.5}};
  EXPECT_TRUE(is_among_heaviest(even, 4, 1));
  EXPECT_FALSE(is_among_heaviest(even, 7, 1));
  EXPECT_FALSE(is_among_heaviest({}, 7, 5));
}

TEST(GraspMetrics, FeixsTypesMergeTo17) {
  std::set<int> classes;
  for (int type = 1; type <= 33; ++type) classes.insert(merged_class(type));
  EXPECT_EQ(classes.size(), 17U);
  EXPECT_EQ(merged_class(30), merged_class(15));
  EXPECT_NE(merged_class(28), merged_class(26));
  EXPECT_EQ(merged_class(104), 104);  // a user's own
}

TEST(Jitter, IsTheSecondDifferenceOfTheErrorOnly) {
  Keypoints off = kFlat.joints;
  off.rightCols<20>().row(1).array() += 0.003;
  // A hand that moves is not jitter, nor is an error that stays or grows evenly.
  const std::vector<Keypoints> still(4, kFlat.joints), wrong(4, off);
  EXPECT_NEAR(unsteadiness_mm(wrong, still), 0, 1e-9);
  EXPECT_NEAR(unsteadiness_mm(wrong, wrong), 0, 1e-9);
  // To and fro: 3 - 2 * 0 + 3 or 0 - 2 * 3 + 0 mm in every joint.
  const std::vector<Keypoints> shaking = {off, kFlat.joints, off, kFlat.joints};
  EXPECT_NEAR(unsteadiness_mm(shaking, still), 6, 1e-9);
  EXPECT_TRUE(std::isnan(unsteadiness_mm({off, off}, {off, off})));
}

TEST(Percentile, IsTheValueOfTheNearestRank) {
  const std::vector<double> five = {15, 20, 35, 40, 50};  // ranks 0.25, 1.5, 2, 2.5 and 5 go up
  EXPECT_EQ(percentile(five, 5), 15);
  EXPECT_EQ(percentile(five, 30), 20);
  EXPECT_EQ(percentile(five, 40), 20);
  EXPECT_EQ(percentile(five, 50), 35);
  EXPECT_EQ(percentile(five, 100), 50);
  std::vector<double> values;
  for (int i = 1; i <= 500; ++i) values.push_back(i);
  EXPECT_EQ(percentile(values, 50), 250);
  EXPECT_EQ(percentile(values, 95), 475);
  EXPECT_EQ(percentile(values, 99), 495);
  EXPECT_EQ(percentile({7}, 1), 7);
  EXPECT_TRUE(std::isnan(percentile({}, 50)));
}

TEST(Spread, KnowsMeanMedianAndNinetiethPercentile) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(100 - i);
  const Spread s = spread(values);
  EXPECT_DOUBLE_EQ(s.mean, 50);
  EXPECT_DOUBLE_EQ(s.median, 50);
  EXPECT_DOUBLE_EQ(s.p90, 90);
  EXPECT_TRUE(std::isnan(spread({}).mean));
}

TEST(Summary, IsTheMeanOverTheFramesWhereAMetricApplies) {
  std::vector<FrameErrors> frames(4, errors_of(kFlat));
  frames[0][kFlips] = 1;
  frames[0][kRotationDeg] = 120;
  frames[1][kGraspTop1] = 1;
  frames[2][kGraspTop1] = 0;
  const Summary summary = summarize(frames);
  EXPECT_DOUBLE_EQ(summary.mean[kFlips], 0.25);
  EXPECT_DOUBLE_EQ(summary.rotation_deg.mean, 30);
  EXPECT_DOUBLE_EQ(summary.mean[kGraspTop1], 0.5);
  EXPECT_TRUE(std::isnan(summary.mean[kGraspTop5]));
  EXPECT_TRUE(std::isnan(summarize({}).mean[kPoseError]));
}

}  // namespace
}  // namespace graspdb
