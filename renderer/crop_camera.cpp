// SPDX-License-Identifier: MIT
#include "graspdb/core/error.h"
#include "graspdb/renderer/renderer.h"
#include "projection.h"

namespace graspdb {

Camera crop_camera(const Eigen::Matrix3d& camera_from_hand, const Eigen::Vector3d& center,
                   double distance, std::span<const Eigen::Vector3f> vertices, int resolution,
                   double margin) {
  GRASPDB_CHECK(!vertices.empty() && resolution > 0 && margin >= 0);
  Camera camera;
  camera.camera_from_hand = {camera_from_hand,
                             Eigen::Vector3d(0, 0, distance) - camera_from_hand * center};
  const auto [low, high, nearest] = tangent_bounds(vertices, camera.camera_from_hand);
  GRASPDB_CHECK(nearest > 0);  // else the crop would have to show what is behind the camera
  const double side = static_cast<double>((high - low).maxCoeff()) * (1 + 2 * margin);
  const Eigen::Array2d middle = (low + high).cast<double>() / 2;
  const double focal = resolution / side;
  const double center_px = (resolution - 1) / 2.0;
  camera.intrinsics = {resolution,
                       resolution,
                       focal,
                       focal,
                       center_px - focal * middle.x(),
                       center_px - focal * middle.y()};
  return camera;
}

}  // namespace graspdb
