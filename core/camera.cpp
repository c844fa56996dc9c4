// SPDX-License-Identifier: MIT
#include "graspdb/core/camera.h"

#include <algorithm>

namespace graspdb {

Intrinsics guess_camera(int width, int height, double focal_px) {
  Intrinsics camera{.width = width, .height = height};
  camera.fx = camera.fy = focal_px > 0 ? focal_px : 0.87 * std::max(width, height);
  camera.cx = (width - 1) / 2.0;
  camera.cy = (height - 1) / 2.0;
  return camera;
}

}  // namespace graspdb
