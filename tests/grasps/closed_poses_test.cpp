// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/random.h"
#include "graspdb/grasps/closing.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

GraspPose random_pose(std::uint64_t seed) {
  RandomStream random(seed);
  GraspPose pose;
  for (int i = 0; i < kAngleCount; ++i) {
    pose.angles[i] = random.uniform(angle_info(i).lower, angle_info(i).upper);
  }
  const Eigen::Vector3d turn(random.normal(), random.normal(), random.normal());
  pose.hand_from_object.rotation = rotation_from_vector(turn.normalized() * random.uniform(0, 3));
  pose.hand_from_object.translation = {random.normal() / 10, random.normal() / 10, -0.05};
  return pose;
}

ClosedPoses toy_poses(const std::map<int, GraspPose>& poses) {
  ClosedPoses closed{.hand = "toy", .hand_length = 0.18, .poses = poses};
  for (const auto& [id, pose] : poses) closed.grasp_hashes[id] = "hash " + std::to_string(id);
  return closed;
}

TEST(ClosedPoses, ReturnFromTheirFileToAHundredthOfAMillimeter) {
  const testing::TemporaryDirectory folder;
  const std::map<int, GraspPose> poses = {{3, random_pose(1)}, {101, random_pose(2)}};
  save_closed_poses(folder / "toy.toml", toy_poses(poses));
  const ClosedPoses back = load_closed_poses(folder / "toy.toml");
  EXPECT_EQ(back.hand_length, 0.18);
  EXPECT_EQ(back.grasp_hashes.at(101), "hash 101");
  const std::map<int, GraspPose>& loaded = back.poses;
  ASSERT_EQ(loaded.size(), 2U);
  for (const auto& [id, pose] : poses) {
    EXPECT_LT((loaded.at(id).angles - pose.angles).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT(
        (loaded.at(id).hand_from_object.translation - pose.hand_from_object.translation).norm(),
        1e-7);
    EXPECT_LT((loaded.at(id).hand_from_object.rotation - pose.hand_from_object.rotation).norm(),
              1e-6);
  }
}

TEST(ClosedPoses, AnglesAtTheirLimitsReturn) {
  const testing::TemporaryDirectory folder;
  GraspPose pose;
  for (int i = 0; i < kAngleCount; ++i) pose.angles[i] = angle_info(i).upper;
  save_closed_poses(folder / "toy.toml", toy_poses({{1, pose}}));
  EXPECT_TRUE(
      load_closed_poses(folder / "toy.toml").poses.at(1).angles.isApprox(pose.angles, 1e-9));
}

TEST(ClosedPoses, TheHandMayHaveAnyName) {
  const testing::TemporaryDirectory folder;
  ClosedPoses closed = toy_poses({{1, random_pose(1)}});
  closed.hand = "my \"left\\right\" hand";
  save_closed_poses(folder / "toy.toml", closed);
  EXPECT_EQ(load_closed_poses(folder / "toy.toml").hand, closed.hand);
}

TEST(ClosedPoses, RefuseOneNumberTwiceAndUnknownKeys) {
  const testing::TemporaryDirectory folder;
  save_closed_poses(folder / "toy.toml", toy_poses({{1, random_pose(1)}}));
  const std::string text = read_text(folder / "toy.toml");
  write_text(folder / "twice.toml", text + text.substr(text.find("[[grasp]]")));
  EXPECT_THROW(load_closed_poses(folder / "twice.toml"), Error);
  write_text(folder / "odd.toml", text + "colour = 3\n");
  EXPECT_THROW(load_closed_poses(folder / "odd.toml"), Error);
}

}  // namespace
}  // namespace graspdb
