// SPDX-License-Identifier: MIT
// How far a set of rotations leaves others from it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "graspdb/core/random.h"
#include "graspdb/core/transform.h"

namespace graspdb::testing {

using Quaternions = Eigen::Matrix<float, Eigen::Dynamic, 4>;

inline Eigen::RowVector4d random_quaternion(RandomStream& random) {
  Eigen::RowVector4d q;
  for (double& value : q) value = random.normal();
  return q.normalized();
}

inline Quaternions quaternions(const std::vector<Eigen::Matrix3d>& rotations) {
  Quaternions rows(static_cast<Eigen::Index>(rotations.size()), 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Eigen::Quaterniond q(rotations[static_cast<std::size_t>(i)]);
    rows.row(i) << static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
        static_cast<float>(q.z());
  }
  return rows;
}

struct NearestAngles {
  double mean_deg = 0, p95_deg = 0, max_deg = 0;
};

// From each of `samples` random rotations to the nearest of the set.
inline NearestAngles nearest_angles(const std::vector<Eigen::Matrix3d>& rotations, int samples) {
  const Quaternions set = quaternions(rotations);
  std::vector<double> angles;
  RandomStream random(1);
  for (int i = 0; i < samples; ++i) {
    const Eigen::Vector4f q = random_quaternion(random).cast<float>().transpose();
    const float cosine = std::min((set * q).cwiseAbs().maxCoeff(), 1.0F);
    angles.push_back(degrees(2 * std::acos(double{cosine})));
  }
  std::sort(angles.begin(), angles.end());
  double sum = 0;
  for (const double angle : angles) sum += angle;
  return {sum / samples, angles[angles.size() * 95 / 100], angles.back()};
}

}  // namespace graspdb::testing
