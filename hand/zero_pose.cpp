// SPDX-License-Identifier: MIT
#include "graspdb/hand/zero_pose.h"

#include <Eigen/Geometry>
#include <cmath>

namespace graspdb {
namespace {

// Three bones in one line from `joint`, then the tip.
void lay_chain(std::size_t first_bone, std::size_t digit, const Eigen::Matrix3d& rotation,
               Eigen::Vector3d joint, const std::array<double, 3>& lengths, Skeleton& skeleton) {
  for (std::size_t bone = 0; bone < 3; ++bone) {
    skeleton.hand_from_bone_at_zero[first_bone + bone] = {rotation, joint};
    joint += rotation.col(1) * lengths[bone];
  }
  skeleton.tip_in_distal[digit] = {0, lengths[2], 0};
}

}  // namespace

Eigen::Matrix3d frame_along(const Eigen::Vector3d& y, const Eigen::Vector3d& z) {
  return rotation_from_axes(1, y, z);
}

Eigen::Matrix3d finger_zero_rotation(int finger) {
  constexpr std::array<double, kFingerCount> kRollDegrees = {6, 1, -4, -9};
  return axis_rotation(1, -radians(kRollDegrees[static_cast<std::size_t>(finger)]));
}

Eigen::Matrix3d thumb_zero_rotation() {
  const Eigen::Vector3d along(-std::sin(radians(38)), std::cos(radians(38)), -.1);
  return frame_along(along, Eigen::Vector3d::UnitZ()) * axis_rotation(1, -radians(85));
}

Skeleton skeleton_from_measures(const HandMeasures& measures) {
  Skeleton skeleton;
  lay_chain(kThumbMetacarpal, 0, thumb_zero_rotation(), measures.cmc[0], measures.lengths[0],
            skeleton);
  for (int finger = 0; finger < kFingerCount; ++finger) {
    const auto digit = static_cast<std::size_t>(finger) + 1;
    const Eigen::Vector3d &cmc = measures.cmc[digit], &mcp = measures.mcp[digit - 1];
    const Eigen::Matrix3d rotation = finger_zero_rotation(finger);
    skeleton.hand_from_bone_at_zero[finger_bone(finger, kMetacarpal)] = {
        frame_along(mcp - cmc, rotation.col(2)), cmc};
    lay_chain(finger_bone(finger, kProximal), digit, rotation, mcp, measures.lengths[digit],
              skeleton);
  }
  return skeleton;
}

}  // namespace graspdb
