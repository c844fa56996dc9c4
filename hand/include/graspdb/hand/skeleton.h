// SPDX-License-Identifier: MIT
// The bones of a hand and where the 28 angles put them. Every frame is seen from the hand frame
// (the palm): origin at the wrist joint, x ulnar, y distal, z dorsal, right hand, metres. A bone's
// frame has its origin in its proximal joint, y towards the next joint and z dorsal (the thumb: to
// the nail).
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

#include "graspdb/core/transform.h"
#include "graspdb/hand/angles.h"

namespace graspdb {

enum Bone : int {  // a type of its own: values go beyond those that have a name
  kPalm = 0,       // the root
  kForearm = 1,    // hangs from the palm at the wrist; its y points distally, into the palm
  kThumbMetacarpal = 2,
  kThumbProximal = 3,
  kThumbDistal = 4,
  kFirstFingerBone = 5,  // then four bones a finger: see finger_bone
};
constexpr int kBoneCount = 21;
enum FingerBone { kMetacarpal = 0, kProximal = 1, kMiddle = 2, kDistal = 3 };

constexpr Bone finger_bone(int finger, FingerBone bone) {
  return static_cast<Bone>(kFirstFingerBone + 4 * finger + bone);
}

std::string_view bone_name(int bone);  // e.g. "index_proximal"
int bone_parent(int bone);             // -1 for the palm; a parent's index is always smaller

template <typename T>
using PerBone = std::array<T, kBoneCount>;

// 0 wrist; 1-4 thumb (CMC, MCP, IP, tip); 5-8 index (MCP, PIP, DIP, tip); 9-12 middle; 13-16 ring;
// 17-20 little: the order of FreiHAND, OpenPose and MediaPipe.
constexpr int kKeypointCount = 21;
using Keypoints = Eigen::Matrix<double, 3, kKeypointCount>;  // a column a point, metres
std::string_view keypoint_name(int keypoint);

// What of a hand's shape the kinematics needs.
struct Skeleton {
  // Where each bone's frame lies when all angles are zero; the palm's is the identity.
  PerBone<RigidTransform> hand_from_bone_at_zero;
  // The tips of thumb, index, middle, ring and little, in the frame of their distal bone.
  std::array<Eigen::Vector3d, 5> tip_in_distal;
};

// Forward kinematics: where each bone's frame lies. Pure, thread-safe, about a microsecond.
// R = Rot(-x, flexion) Rot(z, abduction) Rot(-y, axial): the flexion axis is fixed in the parent.
PerBone<RigidTransform> hand_from_bones(const Skeleton& skeleton, const JointAngles& angles);

// The point of the forearm's axis so many metres beyond the wrist, in the hand frame.
Eigen::Vector3d forearm_point(const Skeleton& skeleton, const JointAngles& angles,
                              double beyond_wrist);

Keypoints keypoints_in_hand(const Skeleton& skeleton,
                            const PerBone<RigidTransform>& hand_from_bone);
Keypoints keypoints_in_hand(const Skeleton& skeleton, const JointAngles& angles);

// The point that cameras look at: the mean of the wrist and the four MCP joints, in the frame of
// the joints or, from angles, in the hand frame.
Eigen::Vector3d palm_center(const Keypoints& joints);
Eigen::Vector3d palm_center(const Skeleton& skeleton, const JointAngles& angles);

// Wrist joint to middle fingertip along the straight hand, metres.
double hand_length(const Skeleton& skeleton);

// One line of JSON and back; every number returns exactly. Parsing throws Error.
std::string skeleton_to_json(const Skeleton& skeleton);
Skeleton skeleton_from_json(std::string_view json, const std::string& file);

}  // namespace graspdb
