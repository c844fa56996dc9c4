// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "graspdb/core/mesh.h"

namespace graspdb {

struct Corners {
  Eigen::Vector3d a, b, c;

  Eigen::Vector3d normal() const;  // its length is twice the area
  double longest_side() const;
};

Corners corners_of(const Mesh& mesh, const Triangle& triangle);

// Signed: of a closed surface that looks outwards it is positive.
double volume_of(const Mesh& mesh);

// How far from `origin` along the unit vector `direction` the nearest of the triangles lies, seen
// from either side.
std::optional<double> distance_along(const Eigen::Vector3d& origin,
                                     const Eigen::Vector3d& direction,
                                     std::span<const Corners> triangles);

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b);
double distance_to_triangle(const Eigen::Vector3d& point, const Corners& triangle);

}  // namespace graspdb
