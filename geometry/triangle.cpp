// SPDX-License-Identifier: MIT
#include "graspdb/geometry/triangle.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace graspdb {

using Eigen::Vector3d;

Corners corners_of(const Mesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]].cast<double>(), mesh.vertices[t[1]].cast<double>(),
          mesh.vertices[t[2]].cast<double>()};
}

Vector3d normal_of(const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  return (b - a).cross(c - a);
}

double longest_side(const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

double quality_of(const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0 ? 2 * std::sqrt(3.0) * normal_of(triangle).norm() / squares : 0;
}

double distance_to_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  return (a + share_of_way(point, a, b) * (b - a) - point).norm();
}

double distance_to_triangle(const Vector3d& point, const Corners& triangle) {
  const Vector3d normal = normal_of(triangle);
  bool above = normal.squaredNorm() > 0;
  double to_sides = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& a = triangle[i];
    const Vector3d& b = triangle[(i + 1) % 3];
    above = above && normal.cross(b - a).dot(point - a) >= 0;
    to_sides = std::min(to_sides, distance_to_segment(point, a, b));
  }
  return above ? std::abs(normal.normalized().dot(point - triangle[0])) : to_sides;
}

NearestOnTriangle nearest_on_triangle(const Vector3d& p, const Corners& triangle) {
  using enum NearestOnTriangle::Part;
  const auto& [a, b, c] = triangle;
  const Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {a, kCornerA};
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {b, kCornerB};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, kEdgeAb};
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {c, kCornerC};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, kEdgeCa};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    return {b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b), kEdgeBc};
  }
  return {a + (vb * ab + vc * ac) / (va + vb + vc), kInside};
}

std::optional<double> distance_along(const Vector3d& origin, const Vector3d& direction,
                                     std::span<const Corners> triangles) {
  std::optional<double> nearest;
  for (const auto& [a, b, c] : triangles) {
    const Vector3d ab = b - a, ac = c - a;
    const Vector3d across = direction.cross(ac), from_a = origin - a;
    const double determinant = ab.dot(across);
    const double u = from_a.dot(across) / determinant;
    if (!(u >= 0 && u <= 1)) continue;  // nor when the ray runs along the triangle
    const Vector3d around = from_a.cross(ab);
    const double v = direction.dot(around) / determinant;
    const double distance = ac.dot(around) / determinant;
    if (!(v >= 0 && u + v <= 1 && distance > 0)) continue;
    nearest = std::min(distance, nearest.value_or(distance));
  }
  return nearest;
}

}  // namespace graspdb
