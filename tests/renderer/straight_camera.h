// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/core/camera.h"

namespace graspdb::testing {

// Looks along z from the origin; the hand frame is the camera frame.
inline Camera straight_camera(int width, int height, double focal) {
  Camera camera;
  camera.intrinsics = {width, height, focal, focal, (width - 1) / 2.0, (height - 1) / 2.0};
  return camera;
}

}  // namespace graspdb::testing
