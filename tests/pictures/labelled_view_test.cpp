// SPDX-License-Identifier: MIT
#include "graspdb/pictures/labelled_view.h"

#include <gmock/gmock.h>

#include <cmath>

#include "graspdb/hand/named_poses.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/hand/turns.h"
#include "graspdb/pictures/pose_file.h"
#include "small_database.h"

namespace graspdb {
namespace {

using ::testing::Each;

Hand default_hand(const std::string& name) {
  const std::filesystem::path hands = std::filesystem::path(GRASPDB_SOURCE_DIR) / "assets/hands";
  return with_visible_forearm(load_hand(hands / (name + ".glb")), 0.015);
}

Subject bare(const Hand& hand, const JointAngles& angles) {
  const GraspPose pose{.angles = angles};
  return {hand, {pose, pose_scene(hand, pose, nullptr), false}};
}

Camera camera_at(const Subject& subject, double yaw, double pitch = 0) {
  const PosedScene& scene = subject.pose().scene;
  return crop_camera(rotation_from_turns({radians(180 + yaw), radians(pitch), 0}), scene.center,
                     0.7, scene.hand_vertices, 160);
}

class EveryHand : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Default, EveryHand,
                         ::testing::Values("male", "female", "slender", "child"));

TEST_P(EveryHand, FlatShowsAllItsJointsFromThePalmAndFromTheBack) {
  const Subject flat = bare(default_hand(GetParam()), JointAngles::Zero());
  for (const double yaw : {0, 25, -25, 180, 155, 205}) {
    const LabelledView view = flat.seen(camera_at(flat, yaw), {}, {});
    EXPECT_THAT(view.joint_states, Each(kVisibleInPicture)) << yaw;
  }
}

TEST_P(EveryHand, FlatHidesAllButOneFingerEdgeOn) {
  const Subject flat = bare(default_hand(GetParam()), JointAngles::Zero());
  const LabelledView thumb_side = flat.seen(camera_at(flat, 90), {}, {});
  const LabelledView little_side = flat.seen(camera_at(flat, -90), {}, {});
  for (const std::size_t knuckle : {13u, 17u}) {
    EXPECT_EQ(thumb_side.joint_states[knuckle], kHiddenInPicture) << knuckle;
  }
  for (const std::size_t knuckle : {5u, 9u, 13u}) {
    EXPECT_EQ(little_side.joint_states[knuckle], kHiddenInPicture) << knuckle;
  }
  EXPECT_EQ(little_side.joint_states[17], kVisibleInPicture);
}

TEST_P(EveryHand, SeenFromTheFingertipsTheirFingersAreHidden) {
  const Subject flat = bare(default_hand(GetParam()), JointAngles::Zero());
  const LabelledView view = flat.seen(camera_at(flat, 0, 88), {}, {});
  for (const std::size_t tip : {8u, 12u, 16u}) {
    EXPECT_EQ(view.joint_states[tip], kVisibleInPicture) << tip;
    EXPECT_EQ(view.joint_states[tip - 3], kHiddenInPicture) << tip;
  }
}

TEST(LabelledView, AFistHidesItsThumbFromBehindAndItsTipsFromThePalm) {
  const Subject fist = bare(default_hand("male"), named_pose("fist"));
  const LabelledView back = fist.seen(camera_at(fist, 180), {}, {});
  EXPECT_EQ(back.joint_states[4], kHiddenInPicture);
  for (const std::size_t knuckle : {5u, 9u, 13u, 17u}) {
    EXPECT_EQ(back.joint_states[knuckle], kVisibleInPicture) << knuckle;
  }
}

TEST(LabelledView, PointsBesideThePictureOrBehindTheCameraAreOutside) {
  const Subject flat = bare(default_hand("male"), JointAngles::Zero());
  Camera camera = camera_at(flat, 0);
  camera.intrinsics.cx += 1000;
  EXPECT_THAT(flat.seen(camera, {}, {}).joint_states, Each(kOutsidePicture));
  camera = camera_at(flat, 0);
  camera.camera_from_hand.translation.z() -= 2;
  EXPECT_THAT(flat.seen(camera, {}, {}).joint_states, Each(kOutsidePicture));
}

TEST(LabelledView, JointsProjectOntoTheirPixelsAndTheWristIsTheHandsOrigin) {
  const Subject flat = bare(default_hand("male"), named_pose("wrap"));
  const LabelledView view = flat.seen(camera_at(flat, 40, 20), {}, {});
  EXPECT_LT((view.joints.col(0) - view.camera.camera_from_hand.translation).norm(), 1e-9);
  for (int i = 0; i < kKeypointCount; ++i) {
    const Eigen::Vector2d px = view.camera.intrinsics.project(view.joints.col(i));
    EXPECT_LT((px - view.joints_px.col(i)).norm(), 1e-9);
  }
}

TEST(LabelledView, CountsAreOfTheirPictures) {
  const PixelCounts none;
  EXPECT_FALSE(none.occlusion());
  EXPECT_NEAR(*(PixelCounts{30, 40}.occlusion()), 0.25, 1e-12);
  const Subject flat = bare(default_hand("child"), JointAngles::Zero());
  const LabelledView view = flat.seen(camera_at(flat, 0), {}, kAllLayers);
  EXPECT_GT(view.hand.visible, 3000);
  EXPECT_EQ(view.hand.visible, view.hand.amodal);
  EXPECT_EQ(view.object.amodal, 0);
  EXPECT_FALSE(view.camera_from_object);
}

}  // namespace
}  // namespace graspdb
