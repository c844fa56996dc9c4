// SPDX-License-Identifier: MIT
// A hand and what it holds as meshes, frame by frame, for renderers of other programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/core/mesh.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// Where everything is in one frame.
struct FrameGeometry {
  GraspPose pose;
  RigidTransform camera_from_hand;
  Eigen::Vector3d towards_light;  // camera frame
};

// What a pixel shows.
enum FrameLabel : std::uint8_t {
  kLabelRest = 0,
  kLabelHand = 1,
  kLabelForearm = 2,  // skin beyond the wrist
  kLabelObject = 3,   // what the hand holds
};
// Where the hand ends: so much of the arm, from the wrist joint, is still hand. Where rows and
// cut_forearm() end, too.
constexpr double kHandBeyondWrist = 0.015;  // metres

struct MeshFrames {
  std::string name;
  double frames_per_second = 10;
  Intrinsics camera;
  Hand hand;                             // with the forearm that is visible
  double visible_forearm = 0;            // metres
  std::shared_ptr<const Solid> object;   // null when none is seen
  Eigen::Vector3d skin_bgr, object_bgr;  // 0..255
  std::vector<FrameGeometry> frames;
};

// FrameLabels of one frame's pixels.
Image<std::uint8_t> frame_labels(const MeshFrames& meshes, std::size_t frame);

// Writes meshes.json, arrays of little-endian numbers and the labels of every frame
// (docs/sequences.md). The folder is new, or holds earlier meshes and nothing else, which go; else
// that is an Error.
void write_meshes(const MeshFrames& meshes, const std::filesystem::path& directory);

}  // namespace graspdb
