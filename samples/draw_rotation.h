// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "graspdb/core/random.h"

namespace graspdb {

// All rotations alike.
inline Eigen::Matrix3d draw_rotation(RandomStream& random) {
  const double w = random.normal(), x = random.normal(), y = random.normal(), z = random.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

}  // namespace graspdb
