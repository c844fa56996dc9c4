// SPDX-License-Identifier: MIT
#include "graspdb/hand_maker.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/random.h"
#include "graspdb/rig.h"
#include "support/compare_hands.h"
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
  for (RigidTransform& frame : hand.palm_from_bone_at_bind) frame = mirrored(frame);
  for (Eigen::Vector3f& v : hand.bind_mesh.vertices) v.x() = -v.x();
  for (Eigen::Vector3f& n : hand.bind_mesh.normals) n.x() = -n.x();
  for (Triangle& t : hand.bind_mesh.triangles) std::swap(t[1], t[2]);
  return hand;
}

TEST(HandMaker, CommittedMaleHandIsTheOneThatIsMade) {
  const Hand made = make_hand(default_hand_shape("male"));
  const Hand committed = load_hand(kHands + "male.glb");
  expect_same_hand(committed, made);
  EXPECT_EQ(committed.name, made.name);
}

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

TEST(HandMaker, BoneAxesOfAFileDoNotMatter) {
  const Hand hand = load_hand(kHands + "male.glb");
  Hand turned = hand;
  RandomStream random(3);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    // The writer takes the nail, the tips and the elbow from these.
    if (bone == kThumbDistal || bone == kForearm || bone % 4 == 0) continue;
    const Eigen::Vector3d turn(random.uniform(), random.uniform(), random.uniform());
    Eigen::Matrix3d& rotation = turned.palm_from_bone_at_bind[bone].rotation;
    rotation = rotation * rotation_from_vector(2 * turn);
  }
  expect_same_hand(written_and_loaded(turned), hand);
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

TEST(HandMaker, RefusesAnUnknownDefaultHand) {
  EXPECT_THROW(default_hand_shape("giant"), Error);
}

}  // namespace
}  // namespace graspdb
