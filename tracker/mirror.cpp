// SPDX-License-Identifier: MIT
#include "mirror.h"

namespace graspdb {
namespace {

Intrinsics mirrored(const Intrinsics& camera) {
  Intrinsics flipped = camera;
  flipped.cx = camera.width - 1 - camera.cx;
  return flipped;
}

}  // namespace

Observation mirrored(const Observation& seen) {
  Observation flipped{mirrored(seen.gray), mirrored(seen.hand), mirrored(seen.camera),
                      seen.segment_ms};
  if (seen.towards_arm)
    flipped.towards_arm = Eigen::Vector2d(-seen.towards_arm->x(), seen.towards_arm->y());
  return flipped;
}

Estimate mirrored(Estimate estimate, int image_width) {
  if (estimate.box.width == 0) return estimate;
  const Eigen::Vector3d flip(-1, 1, 1);
  // Less than nothing, not times -1: 0 stays 0, not -0.
  estimate.roll_deg = 0 - estimate.roll_deg;
  for (Hypothesis& hypothesis : estimate.hypotheses) hypothesis.roll_deg = 0 - hypothesis.roll_deg;
  estimate.box.x = image_width - estimate.box.x - estimate.box.width;
  Eigen::Matrix3d& rotation = estimate.camera_from_hand.rotation;
  rotation = (flip.asDiagonal() * rotation * flip.asDiagonal()).eval();
  estimate.camera_from_hand.translation.x() *= -1;
  estimate.joints.row(0) *= -1;
  estimate.joints_px.row(0) = (image_width - 1) - estimate.joints_px.row(0).array();
  return estimate;
}

}  // namespace graspdb
