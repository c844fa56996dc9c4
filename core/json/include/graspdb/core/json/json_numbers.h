// SPDX-License-Identifier: MIT
// Matrices, frames and cameras as JSON. Lists of numbers are vectors, which any JSON value takes;
// without a rounding every number returns exactly.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/transform.h"

namespace graspdb {

// Roundings for people's programs, steps per unit: no more digits than mean something.
constexpr double kPixelsPerUnit = 1e4;   // 0.0001 pixel
constexpr double kLengthsPerUnit = 1e7;  // 0.1 micrometre
constexpr double kAnglesPerUnit = 1e7;   // radians and entries of rotations

inline double rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit + 0.0;  // never -0
}

// Row by row.
template <typename Matrix>
std::vector<double> numbers(const Matrix& matrix) {
  std::vector<double> list;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) list.push_back(matrix(row, column));
  }
  return list;
}

template <typename Matrix>
std::vector<double> numbers(const Matrix& matrix, double per_unit) {
  std::vector<double> list = numbers(matrix);
  for (double& number : list) number = rounded(number, per_unit);
  return list;
}

// 3 x 4, row by row: the rotation with the translation beside it.
std::vector<double> numbers(const RigidTransform& transform);

// A list for each column.
template <typename Matrix>
std::vector<std::vector<double>> points(const Matrix& columns) {
  std::vector<std::vector<double>> list;
  for (int i = 0; i < columns.cols(); ++i) list.push_back(numbers(columns.col(i)));
  return list;
}

// {"width_px", "height_px", "fx_px", "fy_px", "cx_px", "cy_px"}; read_camera (strict_json.h) reads
// it.
nlohmann::json camera_json(const Intrinsics& camera);

// K, row by row.
std::vector<double> camera_matrix(const Intrinsics& camera);

}  // namespace graspdb
