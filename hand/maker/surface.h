// SPDX-License-Identifier: MIT
// The skin as the zero set of a signed distance.
#pragma once

#include <Eigen/Geometry>

#include "flesh.h"

namespace graspdb {

// Millimetres in the hand frame. Immutable, thread-safe.
class HandSurface {
 public:
  HandSurface(HandFlesh flesh, double width, double forearm_length_mm);

  double distance(const Eigen::Vector3d& point) const;  // negative inside
  Eigen::Vector3d gradient(const Eigen::Vector3d& point) const;
  // Where the line along the gradient meets the surface, for a point that is already near it and a
  // gradient taken close by. To about a micrometre.
  Eigen::Vector3d projected(const Eigen::Vector3d& point, const Eigen::Vector3d& gradient) const;

  const HandFlesh& flesh() const { return flesh_; }
  Eigen::AlignedBox3d bounds() const { return bounds_; }

 private:
  double palm_distance(const Eigen::Vector3d& point) const;

  HandFlesh flesh_;
  double width_;
  double forearm_length_;
  Eigen::AlignedBox3d forearm_box_;
  std::array<Eigen::AlignedBox3d, 5> digit_boxes_;
  Eigen::AlignedBox3d bounds_;
};

}  // namespace graspdb
