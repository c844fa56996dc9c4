// SPDX-License-Identifier: MIT
#include "graspdb/pictures/labelled_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace graspdb {
namespace {

// The bone whose skin lies around a keypoint: the one that starts in it, of a tip the last one.
int bone_around(int keypoint) {
  if (keypoint == 0) return kForearm;
  const int digit = (keypoint - 1) / 4, place = std::min((keypoint - 1) % 4, 2);
  return digit == 0 ? kThumbMetacarpal + place : finger_bone(digit - 1, kProximal) + place;
}

// The straight hand's flesh around a joint: the furthest of its bone's own skin beside it, and of
// any skin right before or behind it, metres.
double flesh_at(const RigidTransform& bone_from_hand, int bone, const Mesh& straight,
                const std::vector<std::uint8_t>& bone_of_vertex) {
  constexpr double kNear = 0.005;  // metres; about two edges of the mesh
  double furthest = 0;
  for (std::size_t v = 0; v < bone_of_vertex.size(); ++v) {
    const Eigen::Vector3d p = bone_from_hand * straight.vertices[v].cast<double>();
    const bool beside = bone_of_vertex[v] == bone && std::abs(p.y()) < kNear;
    if (beside) furthest = std::max(furthest, std::hypot(p.x(), p.z()));
    if (std::hypot(p.x(), p.y()) < kNear) furthest = std::max(furthest, std::abs(p.z()));
  }
  return furthest;
}

int count(const Image<std::uint8_t>& image, std::uint8_t value) {
  return static_cast<int>(std::count(image.begin(), image.end(), value));
}

KeypointState state_of(const Intrinsics& camera, const Eigen::Vector3d& joint, bool seen) {
  if (seen) return kVisibleInPicture;
  return inside_picture(camera, joint) ? kHiddenInPicture : kOutsidePicture;
}

}  // namespace

std::optional<double> PixelCounts::occlusion() const {
  if (amodal == 0) return std::nullopt;
  return 1 - static_cast<double>(visible) / amodal;
}

std::array<double, kKeypointCount> keypoint_radii(const Hand& hand) {
  constexpr double kOblique = 1.25;  // the way through the flesh is longer when it is not square
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const auto hand_from_bone = hand_from_bones(hand.skeleton, JointAngles::Zero());
  const Mesh straight = pose_skin(hand, hand_from_bone);
  std::array<double, kKeypointCount> radii;
  for (int i = 0; i < kKeypointCount; ++i) {
    const int bone = bone_around(i);
    const RigidTransform bone_from_hand = hand_from_bone[static_cast<std::size_t>(bone)].inverse();
    radii[static_cast<std::size_t>(i)] = kOblique * flesh_at(bone_from_hand, bone, straight, bones);
  }
  return radii;
}

Subject::Subject(const Hand& hand, RowPose pose)
    : pose_(std::move(pose)),
      joints_(keypoints_in_hand(hand.skeleton, pose_.pose.angles)),
      radii_(keypoint_radii(hand)) {}

LabelledView Subject::seen(const Camera& camera, const Light& light, const Layers& layers) const {
  LabelledView view;
  view.picture = render(pose_.scene.scene, camera, light, layers);
  view.camera = camera;
  view.angles = pose_.pose.angles;
  std::vector<Eigen::Vector3d> in_hand;
  for (int i = 0; i < kKeypointCount; ++i) in_hand.emplace_back(joints_.col(i));
  const std::vector<bool> visible = visible_points(pose_.scene.scene, camera, in_hand, radii_);
  for (int i = 0; i < kKeypointCount; ++i) {
    const auto place = static_cast<std::size_t>(i);
    view.joints.col(i) = camera.camera_from_hand * in_hand[place];
    view.joints_px.col(i) = camera.intrinsics.project(view.joints.col(i));
    view.joint_states[place] = state_of(camera.intrinsics, view.joints.col(i), visible[place]);
  }
  view.hand = {count(view.picture.label, kHandSurface), count(view.picture.hand_amodal, 255)};
  view.object = {count(view.picture.label, kObjectSurface), count(view.picture.object_amodal, 255)};
  if (pose_.held) view.camera_from_object = camera.camera_from_hand * pose_.pose.hand_from_object;
  return view;
}

}  // namespace graspdb
