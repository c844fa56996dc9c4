// SPDX-License-Identifier: MIT
#include "surface.h"

#include <algorithm>
#include <cmath>

namespace graspdb {
HandSurface::HandSurface(HandFlesh flesh, double width, double forearm_length_mm)
    : flesh_(std::move(flesh)),
      width_(width),
      forearm_length_(forearm_length_mm),
      forearm_box_(flesh_.forearm.bounds()) {
  for (std::size_t i = 0; i < 5; ++i) digit_boxes_[i] = flesh_.digits[i].bounds();
  bounds_ = flesh_.palm.bounds().merged(forearm_box_);
  for (const Eigen::AlignedBox3d& box : digit_boxes_) bounds_.extend(box);
  bounds_.min().y() = -forearm_length_;
  bounds_.min().array() -= 5;  // room for what blending adds
  bounds_.max().array() += 5;
}

double HandSurface::palm_distance(const Eigen::Vector3d& point) const {
  const double palm = flesh_.palm.distance_to(point), blend = 10 * width_;
  if (forearm_box_.exteriorDistance(point) > palm + blend) return palm;
  const double cut = -forearm_length_ - point.y();
  const double forearm = -smooth_min(-flesh_.forearm.distance_to(point), -cut, 6);
  return smooth_min(palm, forearm, blend);
}

double HandSurface::distance(const Eigen::Vector3d& point) const {
  // Each digit grows out of the palm, but digits never melt into each other.
  const double palm = palm_distance(point), blend = 5 * width_;
  double distance = palm;
  for (std::size_t i = 0; i < 5; ++i) {
    if (digit_boxes_[i].exteriorDistance(point) > distance + blend) continue;  // changes nothing
    distance = std::min(distance, smooth_min(palm, flesh_.digits[i].distance_to(point), blend));
  }
  return distance;
}

Eigen::Vector3d HandSurface::gradient(const Eigen::Vector3d& point) const {
  // Four samples at the corners of a tetrahedron.
  constexpr double kStep = .03;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                        Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)}) {
    gradient += distance(point + kStep * corner) * corner;
  }
  return gradient / (4 * kStep);
}

Eigen::Vector3d HandSurface::projected(const Eigen::Vector3d& point,
                                       const Eigen::Vector3d& gradient) const {
  const Eigen::Vector3d step = gradient / std::max(gradient.squaredNorm(), .25);
  Eigen::Vector3d at = point;
  for (int i = 0; i < 6; ++i) {
    const double off = distance(at);
    if (std::abs(off) < 1e-3) break;
    at -= off * step;
  }
  return at;
}

}  // namespace graspdb
