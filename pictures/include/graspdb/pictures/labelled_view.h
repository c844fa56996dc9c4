// SPDX-License-Identifier: MIT
// A picture of a hand with every label that people train and test with.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "graspdb/generator/row_poses.h"

namespace graspdb {

// As COCO's v.
enum KeypointState : std::uint8_t {
  kOutsidePicture = 0,
  kHiddenInPicture = 1,
  kVisibleInPicture = 2
};

struct PixelCounts {
  int visible = 0;
  int amodal = 0;  // as if the other one of hand and object were not there

  // The share that is hidden, 0..1; none of what is not in the picture at all.
  std::optional<double> occlusion() const;
};

struct LabelledView {
  View picture;  // label and shading, and the layers that were asked for
  Camera camera;
  JointAngles angles;
  Keypoints joints;                                    // camera frame, metres
  Eigen::Matrix<double, 2, kKeypointCount> joints_px;  // pixel centres are integers
  std::array<KeypointState, kKeypointCount> joint_states{};
  PixelCounts hand, object;                          // amodal: 0 without that layer
  std::optional<RigidTransform> camera_from_object;  // of a held object
};

// How much of its own flesh may lie before each keypoint, metres: 1.25 times as much as there is
// around it on the straight hand, so that it counts as seen through it up to some 37 degrees off
// square. Of a tip it is what the last joint has. Another finger before it is thicker.
std::array<double, kKeypointCount> keypoint_radii(const Hand& hand);

// A hand in one pose, to be looked at from anywhere. Immutable; thread-safe.
class Subject {
 public:
  Subject(const Hand& hand, RowPose pose);

  const RowPose& pose() const { return pose_; }

  // A keypoint is visible when what is seen first on the way to it is its own flesh: no object, and
  // no hand skin nearer than its depth minus its radius (visible_points).
  // All layers are cast rays (render()), so that they agree with each other; rows are drawn by
  // row_view(), which gives another label to a pixel or two in a million, on edges.
  LabelledView seen(const Camera& camera, const Light& light, const Layers& layers) const;

 private:
  RowPose pose_;
  Keypoints joints_;  // hand frame
  std::array<double, kKeypointCount> radii_;
};

constexpr Layers kAllLayers{.depth = true, .normals = true, .parts = true, .amodal = true};

}  // namespace graspdb
