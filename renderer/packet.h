// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

#include "embree.h"
#include "graspdb/core/camera.h"

namespace graspdb {

// A camera's rays in the hand frame, handed out as packets of 4 x 4 pixels. A direction's length is
// such that a ray's parameter is the planar depth z in metres.
class PixelRays {
 public:
  static constexpr int kTile = 4;
  static constexpr int kLanes = kTile * kTile;

  explicit PixelRays(const Camera& camera);

  // Sets the rays of the tile whose first pixel is (x, y). Lane i is pixel (x + i % 4, y + i / 4).
  void aim(int x, int y, embree::Visible mask, RTCRay16& rays) const;
  // Marks (-1) the lanes that lie inside the picture, as Embree wants it.
  void mark_valid(int x, int y, std::array<int, kLanes>& valid) const;

 private:
  int width_, height_;
  Eigen::Vector3f origin_, first_, per_column_, per_row_;
};

}  // namespace graspdb
