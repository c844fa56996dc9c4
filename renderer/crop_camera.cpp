// SPDX-License-Identifier: MIT
#include <algorithm>

#include "graspdb/error.h"
#include "graspdb/renderer.h"

namespace graspdb {

Camera crop_camera(const Eigen::Matrix3d& camera_from_hand, const Eigen::Vector3d& centre,
                   double distance, std::span<const Eigen::Vector3f> vertices, int resolution,
                   double margin) {
  GRASPDB_CHECK(!vertices.empty() && resolution > 0 && margin >= 0);
  Camera camera;
  camera.camera_from_hand = {camera_from_hand,
                             Eigen::Vector3d(0, 0, distance) - camera_from_hand * centre};
  const Eigen::Matrix3f rotation = camera_from_hand.cast<float>();
  const Eigen::Vector3f translation = camera.camera_from_hand.translation.cast<float>();
  Eigen::Array2f low = Eigen::Array2f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array2f high = -low;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& vertex : vertices) {
    const Eigen::Vector3f in_camera = rotation * vertex + translation;
    const Eigen::Array2f at_unit_depth = in_camera.head<2>().array() / in_camera.z();
    low = low.min(at_unit_depth);
    high = high.max(at_unit_depth);
    nearest = std::min(nearest, in_camera.z());
  }
  GRASPDB_CHECK(nearest > 0);  // else the crop would have to show what is behind the camera
  const double side = static_cast<double>((high - low).maxCoeff()) * (1 + 2 * margin);
  const Eigen::Array2d middle = (low + high).cast<double>() / 2;
  const double focal = resolution / side;
  const double centre_px = (resolution - 1) / 2.0;
  camera.intrinsics = {resolution,
                       resolution,
                       focal,
                       focal,
                       centre_px - focal * middle.x(),
                       centre_px - focal * middle.y()};
  return camera;
}

}  // namespace graspdb
