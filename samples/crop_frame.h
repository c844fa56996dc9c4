// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/core/camera.h"
#include "graspdb/core/transform.h"
#include "graspdb/features/crop.h"

namespace graspdb {

// The rotation from the camera's frame to the crop's, whose axis goes through the crop's middle.
inline Eigen::Matrix3d crop_from_camera(const Intrinsics& camera, const CropSquare& square) {
  const Eigen::Vector2d middle = square.middle();
  return rotation_between(camera.ray(middle.x(), middle.y()), Eigen::Vector3d::UnitZ())
      .toRotationMatrix();
}

}  // namespace graspdb
