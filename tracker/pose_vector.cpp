// SPDX-License-Identifier: MIT
#include "graspdb/pose_vector.h"

#include <algorithm>
#include <cmath>

#include "graspdb/transform.h"

namespace graspdb {

PoseVector pose_vector(const Eigen::Matrix3d& camera_from_hand, const JointAngles& angles) {
  PoseVector x;
  for (int i = 0; i < 9; ++i) x[i] = camera_from_hand(i / 3, i % 3);
  x.tail<kAngleCount>() = angles.array().sin();
  return x;
}

bool is_finite(std::span<const float, kLabelSize> label) {
  return std::all_of(label.begin(), label.end(), [](float value) { return std::isfinite(value); });
}

Eigen::Matrix3d label_rotation(std::span<const float, kLabelSize> label) {
  return rotation_from_vector({label[0], label[1], label[2]});
}

JointAngles label_angles(std::span<const float, kLabelSize> label) {
  return Eigen::Map<const Eigen::Matrix<float, kAngleCount, 1>>(label.data() + 3).cast<double>();
}

}  // namespace graspdb
