// SPDX-License-Identifier: MIT
// Numbers for people's programs: no more digits than mean something.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "graspdb/core/camera.h"

namespace graspdb {

// Steps to which numbers are rounded.
constexpr double kPixelsPerUnit = 1e4;   // 0.0001 pixel
constexpr double kLengthsPerUnit = 1e7;  // 0.1 micrometre
constexpr double kAnglesPerUnit = 1e7;   // radians and entries of rotations

inline double rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit + 0.0;  // never -0
}

// Row by row.
template <typename Matrix>
std::vector<double> numbers(const Matrix& matrix, double per_unit) {
  std::vector<double> list;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) {
      list.push_back(rounded(matrix(row, column), per_unit));
    }
  }
  return list;
}

// K, row by row.
inline std::vector<double> camera_matrix(const Intrinsics& camera) {
  Eigen::Matrix3d k;
  k << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  return numbers(k, 1e6);
}

}  // namespace graspdb
