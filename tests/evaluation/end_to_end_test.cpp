// SPDX-License-Identifier: MIT
// From the rigged hand to its pose in a frame: rows of a small database, seen off the camera's axis
// and at another distance, are found again where they are.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/generator/generator.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/tracker/tracker.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::kSource;
constexpr Intrinsics kFrameCamera{
    .width = 640, .height = 480, .fx = 600, .fy = 600, .cx = 319.5, .cy = 239.5};

TEST(EndToEnd, ARowSeenOffTheAxisIsFoundWithItsPoseAndPlace) {
  const testing::TemporaryDirectory directory;
  BuildConfig config;
  config.hands = {kSource / "assets/hands/male.glb"};
  config.grasps = kSource / "grasps";
  config.only = {14};
  config.objects = Objects::kFree;
  config.steps = 1;
  config.views = 40;
  build_database(config, {.out = directory / "small.graspdb"});
  const Database database = Database::open(directory / "small.graspdb");
  const auto search = make_exact_search(database);
  Tracker tracker(database, *search, tuned_options(TemporalModel::kNone, DescriptorKind::kHog));

  const Hand hand = with_visible_forearm(load_hand(config.hands.front()), config.visible_forearm);
  const Grasp grasp = load_grasp(config.grasps / "14_tripod.toml");
  const GraspPose pose = closed_pose(grasp, hand);
  const PosedScene posed = pose_scene(hand, pose, nullptr);
  const Eigen::Vector3d palm(0.13, -0.05, 0.6);
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), palm).toRotationMatrix();
  for (const std::size_t row : {0U, 7U, 19U, 33U}) {
    const Eigen::Matrix3d rotation = turn * unpack_label(database.label(row)).rotation;
    const Eigen::Vector3d wrist = palm - rotation * posed.center;
    const View view = render(posed.scene, {kFrameCamera, {rotation, wrist}}, config.light);
    const Estimate estimate = tracker.step({view.shading, visible_hand(view), kFrameCamera});
    ASSERT_TRUE(estimate.valid);
    EXPECT_EQ(estimate.row, row);
    EXPECT_LT(degrees(angle_between(estimate.camera_from_hand.rotation, rotation)), 3);
    EXPECT_LT((estimate.camera_from_hand.translation - wrist).norm(), 0.025);
    EXPECT_LT((estimate.angles - pose.angles).cwiseAbs().maxCoeff(), 1e-5);
  }
}

}  // namespace
}  // namespace graspdb
