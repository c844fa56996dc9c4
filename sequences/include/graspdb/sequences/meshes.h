// SPDX-License-Identifier: MIT
// A hand and what it holds as meshes, frame by frame, for renderers of other programs.
#pragma once

#include <cstdint>
#include <filesystem>
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

struct MeshFrames {
  std::string name;
  double frames_per_second = 10;
  Intrinsics camera;
  Hand hand;                                // with the forearm that is visible
  double visible_forearm = 0;               // metres
  std::shared_ptr<const Solid> object;      // null when none is seen
  Eigen::Vector3d skin_bgr, object_bgr;     // 0..255
  std::vector<FrameGeometry> frames;
  std::vector<Image<std::uint8_t>> labels;  // of each frame what its pixels show, or none at all
};

// Writes meshes.json and arrays of little-endian numbers (docs/sequences.md), and labels/000000.png
// and so on where there are labels. The folder is new, or holds earlier meshes and nothing else,
// which go; else that is an Error.
void write_meshes(const MeshFrames& meshes, const std::filesystem::path& directory);

}  // namespace graspdb
