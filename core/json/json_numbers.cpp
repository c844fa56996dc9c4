// SPDX-License-Identifier: MIT
#include "graspdb/core/json/json_numbers.h"

#include <Eigen/Core>

namespace graspdb {

std::vector<double> numbers(const RigidTransform& transform) {
  Eigen::Matrix<double, 3, 4> beside;
  beside << transform.rotation, transform.translation;
  return numbers(beside);
}

nlohmann::json camera_json(const Intrinsics& camera) {
  return {{"width_px", camera.width}, {"height_px", camera.height}, {"fx_px", camera.fx},
          {"fy_px", camera.fy},       {"cx_px", camera.cx},         {"cy_px", camera.cy}};
}

std::vector<double> camera_matrix(const Intrinsics& camera) {
  Eigen::Matrix3d k;
  k << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  return numbers(k, 1e6);
}

}  // namespace graspdb
