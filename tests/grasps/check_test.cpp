// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/closing.h"
#include "graspdb/rig.h"

namespace graspdb {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::filesystem::path kGrasps = GRASPDB_SOURCE_DIR "/grasps";

const Hand& male() {
  static const Hand hand = load_hand(GRASPDB_SOURCE_DIR "/assets/hands/male.glb");
  return hand;
}

// The committed tripod, to break in one way at a time.
class Check : public ::testing::Test {
 protected:
  std::vector<std::string> failures() const {
    return check_grasp(grasp_, male(), rest_, closed_).failures;
  }

  Grasp grasp_ = load_grasp(kGrasps / "14_tripod.toml");
  JointAngles rest_ = load_rest_pose(kGrasps);
  GraspPose closed_ = load_closed_poses(kGrasps / "closed/male.toml").poses.at(14);
};

TEST_F(Check, PassesASoundGraspAndReportsItsSteps) {
  const GraspCheck check = check_grasp(grasp_, male(), rest_, closed_);
  EXPECT_TRUE(check.pass);
  ASSERT_EQ(check.steps.size(), 5U);
  EXPECT_GT(check.steps.front().clearance_mm, 2);
  EXPECT_EQ(check.steps.front().volume_cm3, 0);
  EXPECT_THAT(check.steps.front().contacts, IsEmpty());
  for (const char* bone : {"thumb_distal", "index_distal", "middle_distal"}) {
    EXPECT_THAT(check.steps.back().contacts, Contains(bone));
  }
}

TEST_F(Check, FindsAHandInTheObject) {
  closed_.hand_from_object.translation.y() += 0.005;  // into the two fingers
  EXPECT_THAT(failures(), Contains(HasSubstr("step 5: hand and object overlap")));
}

TEST_F(Check, FindsAThinObjectInTheHand) {
  grasp_.object = make_box({0.06, 0.06, 0.0005});  // no skin vertex lies in it
  closed_.hand_from_object = {Eigen::Matrix3d::Identity(), {0, 0.06, 0.0}};
  EXPECT_GT(check_grasp(grasp_, male(), rest_, closed_).steps.back().penetration_mm, 5);
}

TEST_F(Check, MeasuresTheVolumeThatHandAndObjectShare) {
  const RigidTransform in_the_forearm = {Eigen::Matrix3d::Identity(), {0, -0.06, 0}};
  grasp_.object = make_sphere(0.02);
  closed_.angles[kWristFlexion] = 0;
  closed_.hand_from_object = in_the_forearm;
  const StepCheck step = check_grasp(grasp_, male(), rest_, closed_).steps.back();
  EXPECT_NEAR(step.volume_cm3, 4.0 / 3 * kPi, 0.1);
}

TEST_F(Check, FindsAnObjectInTheWayOfAnEarlierStep) {
  grasp_.approach = {0, 0, 0.08};  // through the palm
  EXPECT_THAT(failures(), Contains(HasSubstr("step 2: hand and object overlap")));
}

TEST_F(Check, FindsADigitThatDoesNotReachTheObject) {
  closed_.angles[finger_angle(0, kMcpFlexion)] -= radians(20);
  EXPECT_THAT(failures(), Contains(HasSubstr("index must touch")));
}

TEST_F(Check, FindsAFreeDigitThatTouches) {
  grasp_.required_digits = {1, 2};
  grasp_.free_digits = {3};
  EXPECT_THAT(failures(), Contains(HasSubstr("middle must stay free")));
}

TEST_F(Check, FindsAnAngleBeyondItsLimit) {
  closed_.angles[finger_angle(3, kPipFlexion)] = radians(115);
  EXPECT_THAT(failures(), Contains(HasSubstr("little_pip_flexion is 115.0 degrees")));
}

TEST_F(Check, FindsDigitsThatOverlap) {
  closed_.angles[finger_angle(2, kMcpFlexion)] = closed_.angles[finger_angle(1, kMcpFlexion)];
  closed_.angles[finger_angle(2, kPipFlexion)] = closed_.angles[finger_angle(1, kPipFlexion)];
  closed_.angles[finger_angle(2, kMcpAbduction)] = radians(15);
  EXPECT_THAT(failures(), Contains(HasSubstr("step 5: digits overlap")));
}

TEST(CommittedGrasps, PassEveryGateOnTheMaleHand) {
  const JointAngles rest = load_rest_pose(kGrasps);
  const std::map<int, GraspPose> closed = load_closed_poses(kGrasps / "closed/male.toml").poses;
  for (const Grasp& grasp : load_grasps(kGrasps)) {
    EXPECT_THAT(check_grasp(grasp, male(), rest, closed.at(grasp.id)).failures, IsEmpty())
        << grasp.name;
  }
}

}  // namespace
}  // namespace graspdb
