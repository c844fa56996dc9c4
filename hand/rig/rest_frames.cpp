// SPDX-License-Identifier: MIT
#include "rest_frames.h"

#include <Eigen/Geometry>

#include "graspdb/hand/digits.h"
#include "graspdb/hand/zero_pose.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

RigidTransform hand_from_file(const RestJoints& joints) {
  const auto from_wrist = [&](int finger) -> Vector3d {
    return joints.origins[finger_bone(finger, kProximal)] - joints.origins[kPalm];
  };
  const Vector3d dorsal = from_wrist(3).cross(from_wrist(0));
  return RigidTransform{frame_along(from_wrist(1), dorsal), joints.origins[kPalm]}.inverse();
}

RestJoints moved(const RigidTransform& to_from, RestJoints joints) {
  for (Vector3d& origin : joints.origins) origin = to_from * origin;
  for (Vector3d& tip : joints.tips) tip = to_from * tip;
  joints.thumb_nail = to_from.rotation * joints.thumb_nail;
  return joints;
}

// The three bones that end at a digit's tip: thumb metacarpal, or a finger's first phalanx, on.
struct Chain {
  std::size_t first_bone;
  std::array<Vector3d, 3> along;  // from joint to joint
};

Chain chain_of(const RestJoints& joints, int digit) {
  Chain chain;
  chain.first_bone = first_bone(digit);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& end = i == 2 ? joints.tips[digit] : joints.origins[chain.first_bone + i + 1];
    chain.along[i] = end - joints.origins[chain.first_bone + i];
  }
  return chain;
}

// The radial-ulnar axis that a finger bends about: the normal of the plane it bends in, or, where
// it is too straight to tell, the one of the flat hand.
Vector3d ulnar_axis(const Chain& chain, int finger) {
  constexpr double kSureBend = radians(10);
  const Vector3d first = chain.along[0].normalized(), middle = chain.along[1].normalized(),
                 last = chain.along[2].normalized();
  Vector3d flat = frame_along(first, finger_zero_rotation(finger).col(2)).col(0);
  if (std::acos(std::clamp(first.dot(last), -1.0, 1.0)) < kSureBend) return flat;
  const Vector3d axis = -(first.cross(middle) + middle.cross(last)).normalized();
  return axis.dot(flat) < 0 ? Vector3d(-axis) : axis;
}

Skeleton skeleton_of(const RestJoints& joints) {
  HandMeasures measures;
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const Chain chain = chain_of(joints, digit);
    for (std::size_t i = 0; i < 3; ++i) measures.lengths[digit][i] = chain.along[i].norm();
    const Bone cmc = digit == 0 ? kThumbMetacarpal : finger_bone(digit - 1, kMetacarpal);
    measures.cmc[digit] = joints.origins[cmc];
    if (digit > 0) measures.mcp[digit - 1] = joints.origins[chain.first_bone];
  }
  return skeleton_from_measures(measures);
}

PerBone<RigidTransform> bone_frames(const RestJoints& joints, const Skeleton& skeleton) {
  // Metacarpals rest at their zero.
  PerBone<RigidTransform> frames = skeleton.hand_from_bone_at_zero;
  frames[kForearm].rotation = frame_along(-joints.origins[kForearm], Vector3d::UnitZ());
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const Chain chain = chain_of(joints, digit);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& along = chain.along[i];
      const Vector3d dorsal =
          digit == 0 ? joints.thumb_nail : Vector3d(ulnar_axis(chain, digit - 1).cross(along));
      const double roll = digit == 0 ? 0 : joints.finger_rolls[digit - 1];
      frames[chain.first_bone + i] = {frame_along(along, dorsal) * axis_rotation(1, -roll),
                                      joints.origins[chain.first_bone + i]};
    }
  }
  return frames;
}

}  // namespace

RestFrames frames_from_joints(const RestJoints& joints) {
  RestFrames frames;
  frames.hand_from_file = hand_from_file(joints);
  const RestJoints in_hand = moved(frames.hand_from_file, joints);
  frames.skeleton = skeleton_of(in_hand);
  frames.hand_from_bone = bone_frames(in_hand, frames.skeleton);
  return frames;
}

}  // namespace graspdb
