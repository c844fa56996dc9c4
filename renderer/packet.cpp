// SPDX-License-Identifier: MIT
#include "packet.h"

#include <limits>

namespace graspdb {

PixelRays::PixelRays(const Camera& camera)
    : width_(camera.intrinsics.width), height_(camera.intrinsics.height) {
  const Intrinsics& k = camera.intrinsics;
  const RigidTransform hand_from_camera = camera.camera_from_hand.inverse();
  const Eigen::Matrix3d& rotation = hand_from_camera.rotation;
  origin_ = hand_from_camera.translation.cast<float>();
  first_ = (rotation * k.ray(0, 0)).cast<float>();
  per_column_ = (rotation.col(0) / k.fx).cast<float>();
  per_row_ = (rotation.col(1) / k.fy).cast<float>();
}

void PixelRays::aim(int x, int y, embree::Visible mask, RTCRay16& rays) const {
  for (int i = 0; i < kLanes; ++i) {
    const int across = i % kTile, down = i / kTile;
    const auto column = static_cast<float>(x + across);
    const auto row = static_cast<float>(y + down);
    rays.dir_x[i] = first_.x() + column * per_column_.x() + row * per_row_.x();
    rays.dir_y[i] = first_.y() + column * per_column_.y() + row * per_row_.y();
    rays.dir_z[i] = first_.z() + column * per_column_.z() + row * per_row_.z();
  }
  for (int i = 0; i < kLanes; ++i) {
    rays.org_x[i] = origin_.x();
    rays.org_y[i] = origin_.y();
    rays.org_z[i] = origin_.z();
    rays.tnear[i] = 0;
    rays.tfar[i] = std::numeric_limits<float>::infinity();
    rays.time[i] = 0;
    rays.mask[i] = mask;
    rays.id[i] = 0;
    rays.flags[i] = 0;
  }
}

void PixelRays::mark_valid(int x, int y, std::array<int, kLanes>& valid) const {
  for (int i = 0; i < kLanes; ++i) {
    valid[static_cast<std::size_t>(i)] = x + i % kTile < width_ && y + i / kTile < height_ ? -1 : 0;
  }
}

}  // namespace graspdb
