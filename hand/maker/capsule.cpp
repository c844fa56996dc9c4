// SPDX-License-Identifier: MIT
#include "capsule.h"

#include <algorithm>
#include <cmath>

#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

// std::hypot guards against overflow, which takes most of a hand's time.
double length_of(double a, double b) {
  return std::sqrt(a * a + b * b);
}

}  // namespace

double distance_to(const FleshCapsule& capsule, const Eigen::Vector3d& point) {
  const Eigen::Vector3d axis = capsule.end - capsule.start, from_start = point - capsule.start;
  const double t = share_of_way(point, capsule.start, capsule.end);
  const double wide = std::lerp(capsule.start_radius, capsule.end_radius, t);
  const double thin = wide * std::lerp(capsule.start_depth, capsule.end_depth, t);
  const Eigen::Vector3d offset = from_start - t * axis;
  const double height = offset.dot(capsule.thin_axis);
  const double across = std::sqrt(std::max(0.0, offset.squaredNorm() - height * height));
  // An ellipse's implicit function divided by its gradient.
  const double value = length_of(across / wide, height / thin);
  const double slope = length_of(across / (wide * wide), height / (thin * thin));
  return slope > 1e-9 ? value * (value - 1) / slope : -thin;
}

double smooth_min(double a, double b, double blend) {
  const double overlap = blend - std::abs(a - b);
  return overlap > 0 ? std::min(a, b) - overlap * overlap / (4 * blend) : std::min(a, b);
}

void Flesh::add(const FleshCapsule& capsule) {
  const double half_length = .5 * (capsule.end - capsule.start).norm();
  parts_.push_back({capsule, .5 * (capsule.start + capsule.end),
                    half_length + std::max(capsule.start_radius, capsule.end_radius)});
}

double Flesh::distance_to(const Eigen::Vector3d& point) const {
  // Away from a flat capsule its distance is up to a tenth too small.
  constexpr double kSafety = .9;
  double distance = 1e9;
  for (const Part& part : parts_) {
    const double least = kSafety * ((point - part.middle).norm() - part.radius);
    if (least > distance + part.capsule.blend) continue;  // changes nothing
    distance = smooth_min(distance, graspdb::distance_to(part.capsule, point), part.capsule.blend);
  }
  return distance;
}

Eigen::AlignedBox3d Flesh::bounds() const {
  Eigen::AlignedBox3d box;
  for (const Part& part : parts_) {
    const FleshCapsule& capsule = part.capsule;
    for (const auto& [center, radius] : {std::pair{capsule.start, capsule.start_radius},
                                         std::pair{capsule.end, capsule.end_radius}}) {
      box.extend(center - Eigen::Vector3d::Constant(radius + capsule.blend / 4));
      box.extend(center + Eigen::Vector3d::Constant(radius + capsule.blend / 4));
    }
  }
  return box;
}

}  // namespace graspdb
