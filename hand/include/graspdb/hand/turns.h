// SPDX-License-Identifier: MIT
// How people say from which side a hand is seen, in sequences and pose files alike.
#pragma once

#include <Eigen/Core>

namespace graspdb {

// The rotation of camera_from_hand. Yaw, pitch, roll = 0, radians: the back of the hand faces the
// camera, fingers up. Then yaw turns about the camera's y, pitch about its x, roll about its z:
// Rz(roll) Rx(pitch) Ry(yaw) Rx(180 degrees).
Eigen::Matrix3d rotation_from_turns(const Eigen::Vector3d& yaw_pitch_roll);

}  // namespace graspdb
