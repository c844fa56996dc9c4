// SPDX-License-Identifier: MIT
#include "graspdb/tracker/pose_vector.h"

namespace graspdb {

PoseVector pose_vector(const Eigen::Matrix3d& rotation, const JointAngles& angles) {
  PoseVector x;
  for (int i = 0; i < 9; ++i) x[i] = rotation(i / 3, i % 3);
  x.tail<kAngleCount>() = angles.array().sin();
  return x;
}

}  // namespace graspdb
