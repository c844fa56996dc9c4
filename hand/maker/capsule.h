// SPDX-License-Identifier: MIT
// Tapered capsules with an elliptic section, and how their distances are joined.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace graspdb {

// Millimetres. At its two ends the section is `radius` wide and `radius * depth` thick along
// `thin_axis` (a unit vector, roughly square to the axis).
struct FleshCapsule {
  Eigen::Vector3d start;
  Eigen::Vector3d end;
  double start_radius;
  double end_radius;
  Eigen::Vector3d thin_axis = Eigen::Vector3d::UnitZ();
  double start_depth = 1;
  double end_depth = 1;
  double blend = 0;  // how softly it joins what came before it: see smooth_min
};

// Signed distance, exact for round capsules without taper, else to first order near the surface.
double distance_to(const FleshCapsule& capsule, const Eigen::Vector3d& point);

// The smaller of two distances, rounded where they differ by less than `blend`; where they are
// equal the surface swells by blend / 4.
double smooth_min(double a, double b, double blend);

// A body of flesh: capsules joined one after the other.
class Flesh {
 public:
  void add(const FleshCapsule& capsule);
  const FleshCapsule& last() const { return parts_.back().capsule; }
  double distance_to(const Eigen::Vector3d& point) const;
  Eigen::AlignedBox3d bounds() const;

 private:
  struct Part {
    FleshCapsule capsule;
    Eigen::Vector3d middle;  // of a sphere round the capsule
    double radius;
  };
  std::vector<Part> parts_;
};

}  // namespace graspdb
