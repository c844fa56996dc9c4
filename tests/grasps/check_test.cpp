// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "support/source_folder.h"

namespace graspdb {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using testing::kGrasps;

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

// A card 1 mm thick: no skin is deeper in it than half of that.
class ThinCard : public Check {
 protected:
  // Before the pulp of the extended index finger, on the palm's side of it by `gap`.
  void put_before_index(double gap) {
    closed_.angles.setZero();
    rest_.setZero();
    grasp_.object = make_box({0.014, 0.008, 0.001});
    grasp_.approach.setZero();
    grasp_.required_digits = {};
    grasp_.free_digits = {};
    const auto posed = hand_from_bones(male().skeleton, closed_.angles);
    const RigidTransform& distal = posed[finger_bone(0, kDistal)];
    double pulp = 0;
    for (const Eigen::Vector3f& v : pose_skin(male(), closed_.angles).vertices) {
      const Eigen::Vector3d p = distal.inverse() * v.cast<double>();
      if (std::abs(p.x()) < 0.007 && std::abs(p.y() - 0.012) < 0.004) pulp = std::min(pulp, p.z());
    }
    closed_.hand_from_object = {distal.rotation, distal * Eigen::Vector3d(0, 0.012, pulp - gap)};
  }
  StepCheck last() const { return check_grasp(grasp_, male(), rest_, closed_).steps.back(); }
};

TEST_F(ThinCard, IsCrossedBySkinThatStandsOutBehindItByLessThanThePenetrationGate) {
  put_before_index(0.001);
  EXPECT_EQ(last().crossing_mm, 0);
  EXPECT_THAT(last().crossed, IsEmpty());
  put_before_index(-0.0008);  // the card's middle is that far in the pulp
  const StepCheck crossed = last();
  EXPECT_LT(crossed.penetration_mm, 2);
  EXPECT_NEAR(crossed.crossing_mm, 0.3, 0.05);
  EXPECT_THAT(crossed.crossed, Contains("index"));
  EXPECT_THAT(failures(), Contains(HasSubstr("are on the wrong side of the object")));
}

TEST_F(ThinCard, IsCrossedByAFingerThatIsBeforeItAtOneStepAndBehindItAtTheNext) {
  put_before_index(0.012);
  closed_.angles[finger_angle(0, kMcpFlexion)] = radians(80);
  const GraspCheck check = check_grasp(grasp_, male(), rest_, closed_);
  int crossings = 0;
  for (const StepCheck& step : check.steps) {
    crossings += std::count(step.crossed.begin(), step.crossed.end(), "index") > 0 ? 1 : 0;
  }
  EXPECT_GT(crossings, 0);
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

TEST_F(Check, FindsAHandThatIsNotClearOfTheObjectAtTheFirstStep) {
  grasp_.approach.setZero();
  rest_ = closed_.angles;
  EXPECT_THAT(failures(), Contains(HasSubstr("step 1: the hand must be clear")));
}

TEST_F(Check, NamesDigitsThatTouchBesideThoseOfTheTaxonomy) {
  EXPECT_THAT(check_grasp(grasp_, male(), rest_, closed_).extra_digits, IsEmpty());
  grasp_.virtual_fingers = {{1}, {2, 4}};
  const GraspCheck check = check_grasp(grasp_, male(), rest_, closed_);
  EXPECT_THAT(check.extra_digits, ElementsAre("middle"));
  EXPECT_THAT(check.missing_digits, ElementsAre("ring"));
  grasp_.virtual_fingers = {{2, 3}};
  EXPECT_THAT(check_grasp(grasp_, male(), rest_, closed_).extra_digits, ElementsAre("thumb"));
  grasp_.opposition = Opposition::kPalm;  // the thumb may help
  EXPECT_THAT(check_grasp(grasp_, male(), rest_, closed_).extra_digits, IsEmpty());
}

TEST_F(Check, NamesAnglesAtTheirLimits) {
  const auto at_limits = [&] {
    return check_grasp(grasp_, male(), rest_, closed_).steps.back().at_limits;
  };
  closed_.angles[kThumbIpFlexion] = radians(79);
  EXPECT_THAT(at_limits(), Not(Contains("thumb_ip_flexion")));
  closed_.angles[kThumbIpFlexion] = radians(79.8);
  EXPECT_THAT(at_limits(), Contains("thumb_ip_flexion"));
}

TEST(SideGrasp, MustTouchWithTheSideThatItsFileNames) {
  Grasp grasp = load_grasp(kGrasps / "16_lateral.toml");
  const JointAngles rest = load_rest_pose(kGrasps);
  const GraspPose closed = load_closed_poses(kGrasps / "closed/male.toml").poses.at(16);
  EXPECT_TRUE(check_grasp(grasp, male(), rest, closed).pass);
  for (ContactArea& area : grasp.contacts) {
    if (area.side == SkinSide::kRadial) area.side = SkinSide::kUlnar, area.name = "middle_ulnar";
  }
  EXPECT_THAT(check_grasp(grasp, male(), rest, closed).failures,
              Contains(HasSubstr("index must touch with its side (middle_ulnar)")));
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
