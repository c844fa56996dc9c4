// SPDX-License-Identifier: MIT
#include "graspdb/hand/skeleton.h"

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr PerBone<std::string_view> kBoneNames = {
    "palm",          "forearm",           "thumb_metacarpal", "thumb_proximal",
    "thumb_distal",  "index_metacarpal",  "index_proximal",   "index_middle",
    "index_distal",  "middle_metacarpal", "middle_proximal",  "middle_middle",
    "middle_distal", "ring_metacarpal",   "ring_proximal",    "ring_middle",
    "ring_distal",   "little_metacarpal", "little_proximal",  "little_middle",
    "little_distal"};

constexpr std::array<std::string_view, kKeypointCount> kKeypointNames = {
    "wrist",     "thumb_cmc", "thumb_mcp",  "thumb_ip",   "thumb_tip",  "index_mcp",  "index_pip",
    "index_dip", "index_tip", "middle_mcp", "middle_pip", "middle_dip", "middle_tip", "ring_mcp",
    "ring_pip",  "ring_dip",  "ring_tip",   "little_mcp", "little_pip", "little_dip", "little_tip"};

Eigen::Matrix3d joint_rotation(double flexion, double abduction = 0, double axial = 0) {
  return axis_rotation(0, -flexion) * axis_rotation(2, abduction) * axis_rotation(1, -axial);
}

// The wrist's angles move the hand against the forearm; here the palm is the one that stays.
Eigen::Matrix3d forearm_rotation(const JointAngles& angles) {
  return joint_rotation(angles[kWristFlexion], angles[kWristDeviation]).transpose();
}

// The rotation of each bone against its parent's zero frame.
PerBone<Eigen::Matrix3d> joint_rotations(const JointAngles& angles) {
  PerBone<Eigen::Matrix3d> rotations;
  rotations[kPalm].setIdentity();
  rotations[kForearm] = forearm_rotation(angles);
  rotations[kThumbMetacarpal] =
      joint_rotation(angles[kThumbCmcFlexion], angles[kThumbCmcAbduction], angles[kThumbCmcAxial]);
  rotations[kThumbProximal] = joint_rotation(angles[kThumbMcpFlexion], angles[kThumbMcpAbduction]);
  rotations[kThumbDistal] = joint_rotation(angles[kThumbIpFlexion]);
  for (int f = 0; f < kFingerCount; ++f) {
    const auto angle = [&](FingerAngle which) { return angles[finger_angle(f, which)]; };
    rotations[finger_bone(f, kMetacarpal)] = joint_rotation(angle(kCmcFlexion));
    rotations[finger_bone(f, kProximal)] = joint_rotation(angle(kMcpFlexion), angle(kMcpAbduction));
    rotations[finger_bone(f, kMiddle)] = joint_rotation(angle(kPipFlexion));
    rotations[finger_bone(f, kDistal)] = joint_rotation(angle(kDipFlexion));
  }
  return rotations;
}

}  // namespace

std::string_view bone_name(int bone) {
  GRASPDB_CHECK(bone >= 0 && bone < kBoneCount);
  return kBoneNames[static_cast<std::size_t>(bone)];
}

std::string_view keypoint_name(int keypoint) {
  GRASPDB_CHECK(keypoint >= 0 && keypoint < kKeypointCount);
  return kKeypointNames[static_cast<std::size_t>(keypoint)];
}

int bone_parent(int bone) {
  GRASPDB_CHECK(bone >= 0 && bone < kBoneCount);
  if (bone == kPalm) return -1;
  if (bone == kForearm || bone == kThumbMetacarpal) return kPalm;
  if (bone < kFirstFingerBone) return bone - 1;
  return (bone - kFirstFingerBone) % 4 == 0 ? static_cast<int>(kPalm) : bone - 1;
}

PerBone<RigidTransform> hand_from_bones(const Skeleton& skeleton, const JointAngles& angles) {
  const PerBone<Eigen::Matrix3d> rotations = joint_rotations(angles);
  const PerBone<RigidTransform>& zero = skeleton.hand_from_bone_at_zero;
  PerBone<RigidTransform> hand_from_bone;
  for (std::size_t bone = 1; bone < kBoneCount; ++bone) {
    const auto parent = static_cast<std::size_t>(bone_parent(static_cast<int>(bone)));
    const RigidTransform parent_from_bone_at_zero = zero[parent].inverse() * zero[bone];
    hand_from_bone[bone] = hand_from_bone[parent] * parent_from_bone_at_zero *
                           RigidTransform{rotations[bone], Eigen::Vector3d::Zero()};
  }
  return hand_from_bone;
}

Eigen::Vector3d forearm_point(const Skeleton& skeleton, const JointAngles& angles,
                              double beyond_wrist) {
  const Eigen::Vector3d in_forearm(0, -beyond_wrist, 0);
  return skeleton.hand_from_bone_at_zero[kForearm] * (forearm_rotation(angles) * in_forearm);
}

Keypoints keypoints_in_hand(const Skeleton& skeleton,
                            const PerBone<RigidTransform>& hand_from_bone) {
  Keypoints points;
  int next = 0;
  const auto add_chain = [&](int first, int last, std::size_t digit) {
    for (int bone = first; bone <= last; ++bone) {
      points.col(next++) = hand_from_bone[static_cast<std::size_t>(bone)].translation;
    }
    points.col(next++) =
        hand_from_bone[static_cast<std::size_t>(last)] * skeleton.tip_in_distal[digit];
  };
  points.col(next++) = hand_from_bone[kPalm].translation;
  add_chain(kThumbMetacarpal, kThumbDistal, 0);
  for (int f = 0; f < kFingerCount; ++f) {
    add_chain(finger_bone(f, kProximal), finger_bone(f, kDistal), static_cast<std::size_t>(f) + 1);
  }
  return points;
}

Keypoints keypoints_in_hand(const Skeleton& skeleton, const JointAngles& angles) {
  return keypoints_in_hand(skeleton, hand_from_bones(skeleton, angles));
}

Eigen::Vector3d palm_center(const Keypoints& joints) {
  return (joints.col(0) + joints.col(5) + joints.col(9) + joints.col(13) + joints.col(17)) / 5;
}

Eigen::Vector3d palm_center(const Skeleton& skeleton, const JointAngles& angles) {
  return palm_center(keypoints_in_hand(skeleton, angles));
}

double hand_length(const Skeleton& skeleton) {
  const Keypoints points = keypoints_in_hand(skeleton, JointAngles::Zero());
  double length = points.col(9).norm();
  for (int joint = 9; joint < 12; ++joint)
    length += (points.col(joint + 1) - points.col(joint)).norm();
  return length;
}

}  // namespace graspdb
