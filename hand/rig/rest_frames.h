// SPDX-License-Identifier: MIT
// Every frame of a right hand from where its joints lie at rest. A file's own bone axes, its
// hierarchy and its rest angles are not needed.
#pragma once

#include <array>

#include "graspdb/hand/skeleton.h"

namespace graspdb {

// In any right-handed frame, metres.
struct RestJoints {
  PerBone<Eigen::Vector3d> origins;  // proximal joints; the palm's is the wrist, the forearm's lies
                                     // nearer the elbow
  std::array<Eigen::Vector3d, 5> tips;
  Eigen::Vector3d thumb_nail;  // a direction
  // How far each finger lies round its length, its back to the thumb's side, beyond what its joints
  // tell; radians.
  std::array<double, kFingerCount> finger_rolls{};
};

struct RestFrames {
  RigidTransform hand_from_file;
  Skeleton skeleton;
  PerBone<RigidTransform> hand_from_bone;  // at rest
};

RestFrames frames_from_joints(const RestJoints& joints);

}  // namespace graspdb
