// SPDX-License-Identifier: MIT
// Points, segments and triangles in space, in any unit of length. Pure, thread-safe.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "graspdb/core/mesh.h"

namespace graspdb {

// Of a triangle, counter-clockwise seen from outside.
using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const Mesh& mesh, const Triangle& triangle);

// Points outwards; its length is twice the area.
Eigen::Vector3d normal_of(const Corners& triangle);
double longest_side(const Corners& triangle);
// 1 when equilateral, near 0 for a sliver, 0 without an area.
double quality_of(const Corners& triangle);

// Which share of the way from `a` to `b` leads to the segment's point nearest to `point`: 0..1, and
// 0 when the segment is a point. Inline, because making a hand spends most of its time here.
inline double share_of_way(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b) {
  const Eigen::Vector3d way = b - a;
  const double length2 = way.squaredNorm();
  return length2 > 0 ? std::clamp((point - a).dot(way) / length2, 0.0, 1.0) : 0.0;
}

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b);

// Of any triangle, also one without an area.
double distance_to_triangle(const Eigen::Vector3d& point, const Corners& triangle);

// Where a triangle is nearest to a point, and on what part of it that is.
struct NearestOnTriangle {
  enum Part { kCornerA, kCornerB, kCornerC, kEdgeAb, kEdgeBc, kEdgeCa, kInside };
  Eigen::Vector3d point;
  Part part;
};
// Of a triangle without an area the point may be no number. Ericson, Real-Time Collision Detection,
// 5.1.5.
NearestOnTriangle nearest_on_triangle(const Eigen::Vector3d& point, const Corners& triangle);

// How far from `origin` along the unit vector `direction` the nearest of the triangles lies, seen
// from either side; nothing when the ray meets none. Möller and Trumbore, "Fast, minimum storage
// ray-triangle intersection" (1997).
std::optional<double> distance_along(const Eigen::Vector3d& origin,
                                     const Eigen::Vector3d& direction,
                                     std::span<const Corners> triangles);

}  // namespace graspdb
