// SPDX-License-Identifier: MIT
#include "geometry.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace graspdb {

using Eigen::Vector3d;

Vector3d Corners::normal() const {
  return (b - a).cross(c - a);
}

double Corners::longest_side() const {
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

Corners corners_of(const Mesh& mesh, const Triangle& t) {
  return {mesh.vertices[t[0]].cast<double>(), mesh.vertices[t[1]].cast<double>(),
          mesh.vertices[t[2]].cast<double>()};
}

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const Corners corners = corners_of(mesh, t);
    volume += corners.a.dot(corners.b.cross(corners.c)) / 6;
  }
  return volume;
}

// Möller and Trumbore, "Fast, minimum storage ray-triangle intersection" (1997).
std::optional<double> distance_along(const Vector3d& origin, const Vector3d& direction,
                                     std::span<const Corners> triangles) {
  std::optional<double> nearest;
  for (const Corners& triangle : triangles) {
    const Vector3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const Vector3d across = direction.cross(ac), from_a = origin - triangle.a;
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

double distance_to_segment(const Vector3d& point, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double squared = along.squaredNorm();
  const double part = squared > 0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + part * along - point).norm();
}

double distance_to_triangle(const Vector3d& point, const Corners& t) {
  const Vector3d normal = t.normal();
  const auto inside_of = [&](const Vector3d& from, const Vector3d& to) {
    return (to - from).cross(point - from).dot(normal) >= 0;
  };
  if (normal.squaredNorm() > 0 && inside_of(t.a, t.b) && inside_of(t.b, t.c) &&
      inside_of(t.c, t.a)) {
    return std::abs((point - t.a).dot(normal)) / normal.norm();
  }
  return std::min({distance_to_segment(point, t.a, t.b), distance_to_segment(point, t.b, t.c),
                   distance_to_segment(point, t.c, t.a)});
}

}  // namespace graspdb
