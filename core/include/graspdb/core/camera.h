// SPDX-License-Identifier: MIT
// The pinhole camera of OpenCV: x right, y down, z forward; integer pixel coordinates are pixel
// centres, so that the centre of a picture is cx = (width - 1) / 2.
#pragma once

#include <Eigen/Core>

#include "graspdb/core/transform.h"

namespace graspdb {

struct Intrinsics {
  int width = 0;  // pixels
  int height = 0;
  double fx = 0;  // pixels
  double fy = 0;
  double cx = 0;
  double cy = 0;

  Eigen::Vector2d project(const Eigen::Vector3d& in_camera) const {
    return {fx * in_camera.x() / in_camera.z() + cx, fy * in_camera.y() / in_camera.z() + cy};
  }
  // The point at z = 1 that projects to (u, v).
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0}; }
};

// Points nearer than this to the camera's plane, metres, are not taken for seen.
constexpr double kNearestDepth = 0.02;

// A camera that takes such pictures, whose axis meets their middle. A focal length of 0 is guessed:
// 60 degrees across the longer side, as many webcams and phones have it.
Intrinsics guess_camera(int width, int height, double focal_px = 0);

struct Camera {
  Intrinsics intrinsics;
  RigidTransform camera_from_hand;
};

}  // namespace graspdb
