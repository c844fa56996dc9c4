// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace graspdb {

// Finds the nearest of many points: a k-d tree in the order of the points. Immutable, thread-safe.
class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Eigen::Vector3f> points);  // one or more

  double distance(const Eigen::Vector3d& to) const;  // in the unit of the points

 private:
  using Part = std::span<const Eigen::Vector3f>;
  static void sort(std::span<Eigen::Vector3f> part, int axis);
  static void search(Part part, int axis, const Eigen::AlignedBox3f& box, const Eigen::Vector3f& to,
                     float& nearest2);

  std::vector<Eigen::Vector3f> points_;
  Eigen::AlignedBox3f box_;
};

}  // namespace graspdb
