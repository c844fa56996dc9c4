// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "graspdb/grasp.h"

namespace graspdb {
namespace {

Grasp approached() {
  Grasp grasp;
  grasp.approach = {0, 0.01, -0.03};
  return grasp;
}

GraspPose some_pose() {
  GraspPose pose;
  for (int i = 0; i < kAngleCount; ++i) pose.angles[i] = 0.02 * i;
  pose.hand_from_object = {axis_rotation(1, 0.3), {0.01, 0.09, -0.05}};
  return pose;
}

const JointAngles kRest = JointAngles::Constant(0.1);

TEST(Steps, LastStepIsTheClosedGrasp) {
  const GraspPose closed = some_pose();
  const GraspPose last = pose_at_step(approached(), kRest, closed, kStepCount);
  EXPECT_EQ(last.angles, closed.angles);
  EXPECT_EQ(last.hand_from_object.translation, closed.hand_from_object.translation);
}

TEST(Steps, AnglesGoEvenlyFromRestToClosed) {
  const GraspPose closed = some_pose();
  for (int step = 0; step <= kStepCount; ++step) {
    const JointAngles angles = pose_at_step(approached(), kRest, closed, step).angles;
    const double share = step / 5.0;
    EXPECT_TRUE(angles.isApprox((1 - share) * kRest + share * closed.angles, 1e-12)) << step;
  }
}

TEST(Steps, HandTranslatesAlongTheApproachAndObjectDoesNotTurn) {
  const GraspPose closed = some_pose();
  for (int step = 0; step <= kStepCount; ++step) {
    const RigidTransform placed = pose_at_step(approached(), kRest, closed, step).hand_from_object;
    EXPECT_EQ(placed.rotation, closed.hand_from_object.rotation);
    const Eigen::Vector3d back = placed.translation - closed.hand_from_object.translation;
    EXPECT_TRUE(back.isApprox((1 - step / 5.0) * approached().approach, 1e-9)) << step;
  }
}

TEST(Steps, OtherStepCountsReachTheSamePoses) {
  const GraspPose closed = some_pose();
  const GraspPose a = pose_at_step(approached(), kRest, closed, 2, 5);
  const GraspPose b = pose_at_step(approached(), kRest, closed, 4, 10);
  EXPECT_TRUE(a.angles.isApprox(b.angles, 1e-12));
  EXPECT_THROW(pose_at_step(approached(), kRest, closed, 6, 5), std::logic_error);
}

}  // namespace
}  // namespace graspdb
