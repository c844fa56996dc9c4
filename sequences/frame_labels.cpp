// SPDX-License-Identifier: MIT
#include "graspdb/generator/posed_scene.h"
#include "graspdb/renderer/renderer.h"
#include "graspdb/sequences/meshes.h"

namespace graspdb {
namespace {

constexpr int kFewestRays = 1;  // no one looks at the shading

}  // namespace

Image<std::uint8_t> frame_labels(const MeshFrames& meshes, std::size_t frame) {
  const auto& [pose, camera_from_hand, light] = meshes.frames.at(frame);
  const PosedScene posed = pose_scene(meshes.hand, pose, meshes.object.get(), kFewestRays);
  const View view =
      render(posed.scene, {meshes.camera, camera_from_hand}, {}, {.depth = true, .parts = true});
  const RigidTransform forearm_from_camera =
      (camera_from_hand * hand_from_bones(meshes.hand.skeleton, pose.angles)[kForearm]).inverse();
  const auto is_beyond_wrist = [&](int x, int y) {
    if (view.part.at(x, y) != kForearm + 1) return false;
    const Eigen::Vector3d skin = meshes.camera.ray(x, y) * double{view.depth.at(x, y)};
    return (forearm_from_camera * skin).y() < -kHandBeyondWrist;
  };
  Image<std::uint8_t> labels(view.label.width(), view.label.height(), kLabelRest);
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      if (view.label.at(x, y) == kObjectSurface) labels.at(x, y) = kLabelObject;
      if (view.label.at(x, y) != kHandSurface) continue;
      labels.at(x, y) = is_beyond_wrist(x, y) ? kLabelForearm : kLabelHand;
    }
  }
  return labels;
}

}  // namespace graspdb
