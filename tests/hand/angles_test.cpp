// SPDX-License-Identifier: MIT
#include "graspdb/hand/angles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

TEST(Angles, FollowTheOrderOfTheLabel) {
  EXPECT_EQ(angle_info(finger_angle(0, kMcpFlexion)).name, "index_mcp_flexion");
  EXPECT_EQ(finger_angle(0, kMcpFlexion), 9);
  EXPECT_EQ(finger_angle(3, kDipFlexion), 27);
  EXPECT_EQ(angle_info(finger_angle(2, kPipFlexion)).name, "ring_pip_flexion");
}

TEST(Angles, RangesAreWholeDegrees) {
  EXPECT_EQ(angle_info(kWristDeviation).lower_deg(), -35);
  for (int i = 0; i < kAngleCount; ++i) {
    const AngleInfo& info = angle_info(i);
    EXPECT_EQ(info.lower_deg(), std::round(info.lower_deg())) << info.name;
    EXPECT_EQ(info.upper_deg(), std::round(info.upper_deg())) << info.name;
    EXPECT_NEAR(radians(info.upper_deg()), info.upper, 1e-12) << info.name;
  }
}

TEST(Angles, ClampLeavesAllowedAnglesAlone) {
  JointAngles angles = JointAngles::Constant(0.02);
  EXPECT_EQ(clamp_to_range(angles), angles);
  EXPECT_EQ(range_excess(angles), 0);
}

TEST(Angles, AbductionFadesToThreeDegreesAsTheFingerFlexes) {
  JointAngles angles = JointAngles::Zero();
  const int abduction = finger_angle(0, kMcpAbduction), flexion = finger_angle(0, kMcpFlexion);
  angles[abduction] = radians(30);
  EXPECT_NEAR(clamp_to_range(angles)[abduction], radians(20), 1e-12);
  angles[flexion] = radians(40);
  EXPECT_NEAR(clamp_to_range(angles)[abduction], radians(11.5), 1e-12);
  angles[flexion] = radians(90);
  EXPECT_NEAR(clamp_to_range(angles)[abduction], radians(3), 1e-12);
  EXPECT_NEAR(range_excess(angles), radians(27), 1e-12);
}

}  // namespace
}  // namespace graspdb
