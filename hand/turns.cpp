// SPDX-License-Identifier: MIT
#include "graspdb/hand/turns.h"

#include "graspdb/core/transform.h"

namespace graspdb {

Eigen::Matrix3d rotation_from_turns(const Eigen::Vector3d& yaw_pitch_roll) {
  // Half a turn about x: the hand's y (distal) goes up, its z (dorsal) towards the camera.
  const Eigen::Matrix3d back_of_upright_hand = axis_rotation(0, kPi);
  return axis_rotation(2, yaw_pitch_roll.z()) * axis_rotation(0, yaw_pitch_roll.y()) *
         axis_rotation(1, yaw_pitch_roll.x()) * back_of_upright_hand;
}

}  // namespace graspdb
