// SPDX-License-Identifier: MIT
#include "graspdb/hand/named_poses.h"

#include <gtest/gtest.h>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

TEST(NamedPoses, StayWithinTheRangesWithAStraightWrist) {
  for (const std::string_view name : kNamedPoses) {
    EXPECT_LT(range_excess(named_pose(name)), 1e-12) << name;
    EXPECT_EQ(named_pose(name)[kWristFlexion], 0) << name;
    EXPECT_EQ(named_pose(name)[kWristDeviation], 0) << name;
  }
  EXPECT_TRUE(named_pose("flat").isZero());
}

TEST(NamedPoses, BendTheFingersAsTheirNamesSay) {
  for (int f = 0; f < kFingerCount; ++f) {
    const int mcp = finger_angle(f, kMcpFlexion), pip = finger_angle(f, kPipFlexion);
    EXPECT_GT(named_pose("fist")[mcp], radians(80));
    EXPECT_GT(named_pose("fist")[pip], radians(100));
    EXPECT_LT(named_pose("hook")[mcp], radians(20));
    EXPECT_GT(named_pose("hook")[pip], radians(90));
    EXPECT_GT(named_pose("wrap")[pip], named_pose("wrap")[mcp]);
  }
}

TEST(NamedPoses, AnotherNameIsRefusedAndTheKnownOnesAreTold) {
  try {
    named_pose("claw");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("flat, fist, wrap, pinch, hook"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("claw"), std::string::npos);
  }
}

}  // namespace
}  // namespace graspdb
