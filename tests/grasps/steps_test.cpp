// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "graspdb/grasps/grasp.h"

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

Waypoint waypoint(double progress) {
  return {progress, JointAngles::Constant(std::numeric_limits<double>::quiet_NaN()), {}};
}

TEST(Steps, HandPassesItsWaypointsAndGoesStraightInBetween) {
  Grasp grasp = approached();
  grasp.waypoints = {waypoint(0.2), waypoint(0.6)};
  grasp.waypoints[0].angles[kThumbIpFlexion] = 0.9;
  grasp.waypoints[1].angles[kThumbIpFlexion] = 0.3;
  grasp.waypoints[1].approach = Eigen::Vector3d(0, 0, -0.04);
  const GraspPose closed = some_pose();
  const auto at = [&](int step) { return pose_at_step(grasp, kRest, closed, step, 10); };
  EXPECT_NEAR(at(1).angles[kThumbIpFlexion], (kRest[kThumbIpFlexion] + 0.9) / 2, 1e-12);
  EXPECT_NEAR(at(2).angles[kThumbIpFlexion], 0.9, 1e-12);
  EXPECT_NEAR(at(4).angles[kThumbIpFlexion], 0.6, 1e-12);
  EXPECT_NEAR(at(6).angles[kThumbIpFlexion], 0.3, 1e-12);
  EXPECT_NEAR(at(8).angles[kThumbIpFlexion], (0.3 + closed.angles[kThumbIpFlexion]) / 2, 1e-12);
  const auto back = [&](int step) {
    return Eigen::Vector3d(at(step).hand_from_object.translation -
                           closed.hand_from_object.translation);
  };
  EXPECT_TRUE(back(3).isApprox((grasp.approach + Eigen::Vector3d(0, 0, -0.04)) / 2, 1e-9));
  EXPECT_TRUE(back(8).isApprox(Eigen::Vector3d(0, 0, -0.02), 1e-9));
}

TEST(Steps, WhatAWaypointDoesNotStateGoesStraight) {
  Grasp grasp = approached();
  const GraspPose closed = some_pose();
  const GraspPose straight = pose_at_step(grasp, kRest, closed, 2);
  grasp.waypoints = {waypoint(0.5)};
  const GraspPose same = pose_at_step(grasp, kRest, closed, 2);
  EXPECT_EQ(same.angles, straight.angles);
  EXPECT_EQ(same.hand_from_object.translation, straight.hand_from_object.translation);
}

}  // namespace
}  // namespace graspdb
