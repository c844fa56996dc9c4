// SPDX-License-Identifier: MIT
#include "graspdb/grasps/closing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/core/file.h"
#include "graspdb/hand/rig/rig.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"
#include "support/toy_hand.h"

namespace graspdb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using testing::kGrasps;

TEST(Closing, ToyHandHoldsABallWithoutEnteringItAndInsideTheRanges) {
  const Hand hand = testing::toy_hand();
  Grasp grasp = load_grasp(kGrasps / "11_power_sphere.toml");
  grasp.approach.setZero();  // this is about the last step
  const GraspPose closed = close_grasp(grasp, hand);
  const GraspCheck check = check_grasp(grasp, hand, closed.angles, closed);
  EXPECT_LT(check.steps.back().penetration_mm, 1.5);
  EXPECT_EQ(check.steps.back().clearance_mm, 0);
  EXPECT_GE(check.steps.back().contacts.size(), 9U);
  // It starts where it ends, which is all that may be said against it.
  EXPECT_THAT(check.failures, ElementsAre(HasSubstr("step 1: the hand must be clear")));
  EXPECT_LT(range_excess(closed.angles), 1e-12);
  EXPECT_EQ(closed.angles[kWristFlexion], grasp.start.angles[kWristFlexion]);
}

TEST(Closing, GivesTheSameBitsTwice) {
  const Hand hand = testing::toy_hand();
  const Grasp grasp = load_grasp(kGrasps / "14_tripod.toml");
  const GraspPose a = close_grasp(grasp, hand), b = close_grasp(grasp, hand);
  EXPECT_EQ(a.angles, b.angles);
  EXPECT_EQ(a.hand_from_object.rotation, b.hand_from_object.rotation);
  EXPECT_EQ(a.hand_from_object.translation, b.hand_from_object.translation);
}

TEST(Closing, AgreesWithTheCommittedPoseToATenthOfAMillimeter) {
  const Hand hand = load_hand(GRASPDB_SOURCE_DIR "/assets/hands/male.glb");
  const Grasp grasp = load_grasp(kGrasps / "09_palmar_pinch.toml");
  const GraspPose committed = load_closed_poses(kGrasps / "closed/male.toml").poses.at(9);
  const GraspPose closed = close_grasp(grasp, hand);
  const Mesh a = pose_skin(hand, closed.angles), b = pose_skin(hand, committed.angles);
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    ASSERT_LT((a.vertices[v] - b.vertices[v]).norm(), 1e-4F);
  }
  for (const Eigen::Vector3f& v : grasp.object->mesh().vertices) {
    const Eigen::Vector3d p = v.cast<double>();
    ASSERT_LT((closed.hand_from_object * p - committed.hand_from_object * p).norm(), 1e-4);
  }
}

TEST(Closing, HoldsTheMeshOfAMugWithoutPassingItsWalls) {
  const Hand hand = testing::toy_hand();
  const Grasp grasp = load_grasp(kGrasps / "examples/100_mug.toml");
  const GraspPose closed = close_grasp(grasp, hand);
  const GraspCheck check = check_grasp(grasp, hand, load_rest_pose(kGrasps / "examples"), closed);
  EXPECT_LT(check.steps.back().penetration_mm, 4);  // less than the wall is thick
  EXPECT_EQ(check.steps.back().crossing_mm, 0);
  EXPECT_GE(check.steps.back().contacts.size(), 9U);
  EXPECT_THAT(check.missing_digits, IsEmpty());
}

TEST(FittedTo, ChangesOnlyAnObjectThatScalesWithTheHand) {
  const Hand hand = testing::toy_hand();
  const double share = hand_length(hand.skeleton) / kReferenceHandLength;
  ASSERT_GT(std::abs(share - 1), 0.01);
  Grasp grasp = load_grasp(kGrasps / "14_tripod.toml");
  const Eigen::Vector3d stated = grasp.object->half_extents();
  EXPECT_EQ(fitted_to(hand, grasp).object, grasp.object);
  grasp.object_scales = true;
  const Grasp fitted = fitted_to(hand, grasp);
  EXPECT_TRUE(fitted.object->half_extents().isApprox(share * stated));
  EXPECT_EQ(fitted_to(hand, fitted).object, fitted.object);
}

TEST(FittedTo, IsWhatClosingAndCheckHold) {
  const Hand hand = testing::toy_hand();
  Grasp stated = load_grasp(kGrasps / "14_tripod.toml");
  stated.object_scales = true;
  const Grasp fitted = fitted_to(hand, stated);
  const GraspPose closed = close_grasp(stated, hand);
  EXPECT_EQ(closed.angles, close_grasp(fitted, hand).angles);
  const JointAngles rest = load_rest_pose(kGrasps);
  EXPECT_EQ(check_grasp(stated, hand, rest, closed).steps[0].clearance_mm,
            check_grasp(fitted, hand, rest, closed).steps[0].clearance_mm);
}

// The committed pose holds for this hand and this file only.
TEST(ClosedPose, IsClosedAnewForAnotherHandOfTheSameNameAndForAnEditedFile) {
  const testing::TemporaryDirectory folder;
  std::filesystem::create_directory(folder / "closed");
  std::filesystem::copy_file(kGrasps / "09_palmar_pinch.toml", folder / "pinch.toml");
  const Grasp grasp = load_grasp(folder / "pinch.toml");
  Hand hand = load_hand(GRASPDB_SOURCE_DIR "/assets/hands/male.glb");
  GraspPose marked = closed_pose(grasp, hand);
  marked.angles[kWristFlexion] = 0.5;  // no closing gives that
  const ClosedPoses closed{.hand = hand.name,
                           .hand_length = hand_length(hand.skeleton),
                           .poses = {{9, marked}},
                           .grasp_hashes = {{9, grasp_hash(grasp)}}};
  save_closed_poses(closed_poses_file(grasp, hand), closed);
  EXPECT_NEAR(closed_pose(grasp, hand).angles[kWristFlexion], 0.5, 1e-6);

  Hand longer = hand;
  for (Eigen::Vector3d& tip : longer.skeleton.tip_in_distal) tip *= 1.05;
  EXPECT_NE(closed_pose(grasp, longer).angles[kWristFlexion], 0.5);

  write_text(grasp.file, read_text(grasp.file) + "\n# edited\n");
  EXPECT_NE(closed_pose(grasp, hand).angles[kWristFlexion], 0.5);
}

TEST(GraspHash, ChangesWithTheMeshOfTheObject) {
  const testing::TemporaryDirectory folder;
  Grasp grasp = load_grasp(kGrasps / "09_palmar_pinch.toml");
  const std::string alone = grasp_hash(grasp);
  grasp.object_file = folder / "some.obj";
  write_text(grasp.object_file, "v 0 0 0");
  const std::string with_mesh = grasp_hash(grasp);
  EXPECT_NE(with_mesh, alone);
  write_text(grasp.object_file, "v 0 0 1");
  EXPECT_NE(grasp_hash(grasp), with_mesh);
}

}  // namespace
}  // namespace graspdb
