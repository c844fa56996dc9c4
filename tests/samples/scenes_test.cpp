// SPDX-License-Identifier: MIT
#include "graspdb/samples/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/renderer/renderer.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::TemporaryDirectory;

const SceneMaker& scene_maker() {
  static const SceneMaker maker({.hands = {data_directory() / "assets/hands/male.glb"}},
                                {.frames = 3, .width = 160, .height = 120});
  return maker;
}

std::size_t pixels_of(const Image<std::uint8_t>& labels, FrameLabel label) {
  return static_cast<std::size_t>(std::ranges::count(labels, label));
}

TEST(SceneMaker, ASceneDependsOnItsNumberAlone) {
  const MeshFrames a = scene_maker().make(7), again = scene_maker().make(7),
                   other = scene_maker().make(8);
  EXPECT_EQ(frame_labels(a, 2), frame_labels(again, 2));
  EXPECT_EQ(a.frames[1].camera_from_hand.translation, again.frames[1].camera_from_hand.translation);
  EXPECT_NE(a.frames[1].camera_from_hand.translation, other.frames[1].camera_from_hand.translation);
  EXPECT_EQ(a.frames.size(), 3u);
}

// Whether the pixel or one beside it has a label: vertices of an outline project beside it.
bool is_near_label(const Image<std::uint8_t>& labels, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(std::lround(pixel.x())),
            y = static_cast<int>(std::lround(pixel.y()));
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, labels.height() - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, labels.width() - 1); ++u) {
      if (labels.at(u, v) != kLabelRest) return true;
    }
  }
  return false;
}

TEST(SceneMaker, LabelsAreWhereTheHandProjects) {
  for (std::uint64_t number = 0; number < 12; ++number) {
    const MeshFrames scene = scene_maker().make(number);
    const FrameGeometry& frame = scene.frames[1];
    const Image<std::uint8_t> labels = frame_labels(scene, 1);
    std::size_t missed = 0, seen = 0;
    for (const Eigen::Vector3f& vertex : pose_skin(scene.hand, frame.pose.angles).vertices) {
      const Eigen::Vector3d skin = frame.camera_from_hand * vertex.cast<double>();
      if (!inside_picture(scene.camera, skin)) continue;
      ++seen;
      missed += !is_near_label(labels, scene.camera.project(skin));
    }
    EXPECT_GT(seen, 100u) << number;
    EXPECT_EQ(missed, 0u) << number;
  }
}

TEST(SceneMaker, LabelsTellHandForearmAndObject) {
  int with_object = 0, with_forearm = 0;
  for (std::uint64_t number = 0; number < 12; ++number) {
    const MeshFrames scene = scene_maker().make(number);
    const Image<std::uint8_t> labels = frame_labels(scene, 1);
    EXPECT_GT(pixels_of(labels, kLabelHand), 50u) << number;
    if (pixels_of(labels, kLabelObject) > 0) {
      EXPECT_TRUE(scene.object) << number;
      ++with_object;
    }
    if (scene.visible_forearm < kHandBeyondWrist) {
      EXPECT_EQ(pixels_of(labels, kLabelForearm), 0u) << number;
    }
    with_forearm += pixels_of(labels, kLabelForearm) > 0;
  }
  EXPECT_GE(with_object, 3);
  EXPECT_GE(with_forearm, 3);
}

TEST(SceneMaker, HandsAreSeenAndArmsDoNotReachTheCamera) {
  for (std::uint64_t number = 20; number < 40; ++number) {
    const MeshFrames scene = scene_maker().make(number);
    for (const FrameGeometry& frame : scene.frames) {
      const auto joints = keypoints_in_hand(scene.hand.skeleton, frame.pose.angles);
      const Eigen::Vector3d palm = palm_center(scene.hand.skeleton, frame.pose.angles);
      EXPECT_TRUE(inside_picture(scene.camera, frame.camera_from_hand * palm)) << number;
      int inside = 0;
      for (const auto& joint : joints.colwise())
        inside += inside_picture(scene.camera, frame.camera_from_hand * Eigen::Vector3d(joint));
      EXPECT_GE(inside, 11) << number;
      const auto bones = hand_from_bones(scene.hand.skeleton, frame.pose.angles);
      const Eigen::Vector3d elbow =
          frame.camera_from_hand * (-0.26 * bones[kForearm].rotation.col(1));
      EXPECT_GE(elbow.z(), 0.15) << number;
    }
  }
}

TEST(SceneMaker, ItsFolderIsThatOfMeshes) {
  const TemporaryDirectory directory;
  write_meshes(scene_maker().make(3), directory.path());
  const auto header = nlohmann::json::parse(read_text(directory / "meshes.json"));
  EXPECT_EQ(header["name"], "scene-000003");
  EXPECT_EQ(header["frames"].size(), 3u);
}

}  // namespace
}  // namespace graspdb
