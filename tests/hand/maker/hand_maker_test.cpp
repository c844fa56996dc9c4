// SPDX-License-Identifier: MIT
#include "graspdb/hand/maker/hand_maker.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/random.h"
#include "graspdb/hand/rig/rig.h"
#include "support/compare_hands.h"
#include "support/made_hands.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::expect_same_hand;
using testing::TemporaryDirectory;

const std::string kHands = GRASPDB_SOURCE_DIR "/assets/hands/";

// The file takes its name from the hand's.
Hand written_and_loaded(const Hand& hand) {
  const TemporaryDirectory directory;
  write_hand(hand, directory / (hand.name + ".glb"));
  return load_hand(directory / (hand.name + ".glb"));
}

RigidTransform mirrored(const RigidTransform& transform) {
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  return {mirror * transform.rotation * mirror, mirror * transform.translation};
}

// The left hand of a right one.
Hand mirrored(Hand hand) {
  for (RigidTransform& frame : hand.hand_from_bone_at_bind) frame = mirrored(frame);
  for (Eigen::Vector3f& v : hand.bind_mesh.vertices) v.x() = -v.x();
  for (Eigen::Vector3f& n : hand.bind_mesh.normals) n.x() = -n.x();
  for (Triangle& t : hand.bind_mesh.triangles) std::swap(t[1], t[2]);
  return hand;
}

class CommittedHand : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedHand, IsTheOneThatIsMade) {
  const Hand made = make_hand(default_hand_shape(GetParam()));
  const Hand committed = load_hand(kHands + GetParam() + ".glb");
  expect_same_hand(committed, made);
  EXPECT_EQ(committed.name, made.name);
}

INSTANTIATE_TEST_SUITE_P(Hands, CommittedHand, ::testing::ValuesIn(testing::made_hands()),
                         [](const auto& test) { return test.param; });

TEST(HandMaker, WrittenHandIsLoadedAsItWas) {
  const Hand hand = load_hand(kHands + "male.glb");
  expect_same_hand(written_and_loaded(hand), hand);
}

TEST(HandMaker, WritingTwiceGivesTheSameBytes) {
  const TemporaryDirectory directory;
  const Hand hand = load_hand(kHands + "male.glb");
  write_hand(hand, directory / "a.glb");
  write_hand(hand, directory / "b.glb");
  EXPECT_EQ(read_text(directory / "a.glb"), read_text(directory / "b.glb"));
}

TEST(HandMaker, ARigMapOfSomebodyElseIsNotWrittenOver) {
  const TemporaryDirectory directory;
  const Hand hand = load_hand(kHands + "male.glb");
  write_text(directory / "a.rig.toml", "handedness = \"left\"\n");
  EXPECT_THROW(write_hand(hand, directory / "a.glb"), Error);
  EXPECT_EQ(read_text(directory / "a.rig.toml"), "handedness = \"left\"\n");
  EXPECT_FALSE(std::filesystem::exists(directory / "a.glb"));
  write_hand(hand, directory / "b.glb");
  write_hand(hand, directory / "b.glb");  // its own
}

TEST(HandMaker, BoneAxesOfAFileDoNotMatter) {
  const Hand hand = load_hand(kHands + "male.glb");
  Hand turned = hand;
  RandomStream random(3);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    // The writer takes the nail, the tips and the elbow from these.
    if (bone == kThumbDistal || bone == kForearm || bone % 4 == 0) continue;
    const Eigen::Vector3d turn(random.uniform(), random.uniform(), random.uniform());
    Eigen::Matrix3d& rotation = turned.hand_from_bone_at_bind[bone].rotation;
    rotation = rotation * rotation_from_vector(2 * turn);
  }
  expect_same_hand(written_and_loaded(turned), hand);
}

// As if the hand had been bound in another pose and at another place of the file.
Hand bound_elsewhere(const Hand& hand, const JointAngles& angles, const RigidTransform& moved) {
  Hand other = hand;
  const PerBone<RigidTransform> frames = hand_from_bones(hand.skeleton, angles);
  other.bind_mesh = pose_skin(hand, frames);
  for (std::size_t b = 0; b < kBoneCount; ++b) other.hand_from_bone_at_bind[b] = moved * frames[b];
  for (Eigen::Vector3f& v : other.bind_mesh.vertices) v = (moved * v.cast<double>()).cast<float>();
  return other;
}

TEST(HandMaker, AnglesMeanTheSameFromWhateverRestPose) {
  const Hand hand = load_hand(kHands + "male.glb");
  JointAngles bent = JointAngles::Zero();
  for (int f = 0; f < kFingerCount; ++f) {
    bent[finger_angle(f, kMcpFlexion)] = radians(50);
    bent[finger_angle(f, kMcpAbduction)] = radians(5 - 3 * f);
    bent[finger_angle(f, kPipFlexion)] = radians(60 + 5 * f);
    bent[finger_angle(f, kDipFlexion)] = radians(20);
  }
  bent[kThumbCmcFlexion] = bent[kThumbCmcAxial] = bent[kThumbIpFlexion] = radians(25);
  bent[kWristFlexion] = radians(-30);
  const RigidTransform place{rotation_from_vector({.3, -2, 1}), {.4, -1, 2}};
  for (const JointAngles& rest : {JointAngles(JointAngles::Zero()), bent}) {
    const Hand loaded = written_and_loaded(bound_elsewhere(hand, rest, place));
    EXPECT_LT(testing::largest_difference(loaded.skeleton, hand.skeleton), 2e-6);
    const auto frames = hand_from_bones(hand.skeleton, rest);
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      EXPECT_LT(angle_between(loaded.hand_from_bone_at_bind[bone].rotation, frames[bone].rotation),
                2e-4)
          << bone_name(static_cast<int>(bone));
    }
  }
}

TEST(HandMaker, UnitOfAFileIsInItsRigMap) {
  const Hand hand = load_hand(kHands + "male.glb");
  Hand centimeters = hand;
  for (RigidTransform& frame : centimeters.hand_from_bone_at_bind) frame.translation *= 100;
  for (Eigen::Vector3d& tip : centimeters.skeleton.tip_in_distal) tip *= 100;
  for (Eigen::Vector3f& v : centimeters.bind_mesh.vertices) v *= 100;
  const TemporaryDirectory directory;
  write_hand(centimeters, directory / "male.glb");
  EXPECT_THROW(load_hand(directory / "male.glb"), Error);
  const std::string map = read_text(directory / "male.rig.toml");
  write_text(directory / "male.rig.toml", "metres_per_unit = 0.01\n" + map);
  expect_same_hand(load_hand(directory / "male.glb"), hand);
}

TEST(HandMaker, LeftHandIsMirroredOnTheWayIn) {
  const TemporaryDirectory directory;
  const Hand hand = load_hand(kHands + "male.glb");
  write_hand(mirrored(hand), directory / "male.glb");
  EXPECT_THROW(load_hand(directory / "male.glb"), Error);  // the map still says it is right
  std::string map = read_text(directory / "male.rig.toml");
  map.replace(map.find("\"right\""), 7, "\"left\"");
  write_text(directory / "male.rig.toml", map);
  expect_same_hand(load_hand(directory / "male.glb"), hand);
}

Eigen::AlignedBox3f box_of(const Hand& hand) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : hand.bind_mesh.vertices) box.extend(vertex);
  return box;
}

TEST(HandMaker, ACoarseHandIsTheSameHandOfFewerTriangles) {
  const Hand fine = load_hand(kHands + "child.glb");
  const Hand coarse = make_hand(default_hand_shape("child"), 1.5);
  EXPECT_NEAR(static_cast<double>(coarse.bind_mesh.triangles.size()),
              static_cast<double>(fine.bind_mesh.triangles.size()) / (1.5 * 1.5), 10);
  EXPECT_TRUE(box_of(coarse).min().isApprox(box_of(fine).min(), 0.01F));
  EXPECT_TRUE(box_of(coarse).max().isApprox(box_of(fine).max(), 0.01F));
  EXPECT_TRUE(coarse.skeleton.tip_in_distal[0].isApprox(fine.skeleton.tip_in_distal[0], 1e-5));
}

TEST(HandMaker, RefusesAnUnknownDefaultHand) {
  EXPECT_THROW(default_hand_shape("giant"), Error);
}

TEST(HandMaker, NamesTheMeasureThatNoHandHas) {
  HandShape shape = default_hand_shape("male");
  shape.finger_breadth_mm = 60;
  try {
    make_hand(shape);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().key, "finger_breadth_mm");
  }
}

}  // namespace
}  // namespace graspdb
