// SPDX-License-Identifier: MIT
#include "mirror.h"

#include <algorithm>

namespace graspdb {

GrayImage mirrored(const GrayImage& image) {
  GrayImage flipped(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    std::reverse_copy(image.row(y), image.row(y) + image.width(), flipped.row(y));
  }
  return flipped;
}

Intrinsics mirrored(const Intrinsics& camera) {
  Intrinsics flipped = camera;
  flipped.cx = camera.width - 1 - camera.cx;
  return flipped;
}

Estimate mirrored(Estimate estimate, int image_width) {
  if (estimate.box.width == 0) return estimate;
  const Eigen::Vector3d flip(-1, 1, 1);
  estimate.box.x = image_width - estimate.box.x - estimate.box.width;
  estimate.camera_from_hand = flip.asDiagonal() * estimate.camera_from_hand * flip.asDiagonal();
  estimate.wrist.x() *= -1;
  estimate.joints.row(0) *= -1;
  estimate.joints_px.row(0) = (image_width - 1) - estimate.joints_px.row(0).array();
  return estimate;
}

}  // namespace graspdb
