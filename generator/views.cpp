// SPDX-License-Identifier: MIT
#include "graspdb/views.h"

#include <Eigen/Geometry>
#include <cmath>

#include "graspdb/error.h"
#include "graspdb/transform.h"

namespace graspdb {

std::vector<Eigen::Matrix3d> view_rotations(int count) {
  GRASPDB_CHECK(count > 0);
  // The two irrational turns of the paper: sqrt(2) and the positive root of psi^4 = psi + 4.
  const double phi = std::sqrt(2.0);
  const double psi = 1.533751168755204288118041;
  std::vector<Eigen::Matrix3d> rotations;
  rotations.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5;
    const double r = std::sqrt(s / count);
    const double complement = std::sqrt(1 - s / count);
    const double alpha = 2 * kPi * s / phi;
    const double beta = 2 * kPi * s / psi;
    const Eigen::Quaterniond q(complement * std::cos(beta), r * std::sin(alpha),
                               r * std::cos(alpha), complement * std::sin(beta));
    rotations.push_back(q.toRotationMatrix());
  }
  return rotations;
}

}  // namespace graspdb
