// SPDX-License-Identifier: MIT
// Closed meshes whose pictures are known.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "graspdb/core/mesh.h"
#include "graspdb/core/transform.h"

namespace graspdb::testing {

// A capsule along y: a tube of `half_length` to each side of `centre`, closed by half spheres. With
// half_length 0 it is a sphere. Every vertex lies on the true surface.
inline Mesh capsule(const Eigen::Vector3d& center, double radius, double half_length,
                    int segments = 96) {
  Mesh mesh;
  const int rings = segments / 2;
  for (int r = 0; r <= rings; ++r) {
    const double polar = kPi * r / rings;
    for (int s = 0; s < segments; ++s) {
      const double around = 2 * kPi * s / segments;
      const Eigen::Vector3d normal(std::sin(polar) * std::cos(around), std::cos(polar),
                                   std::sin(polar) * std::sin(around));
      const Eigen::Vector3d end(0, 2 * r < rings ? half_length : -half_length, 0);
      mesh.vertices.push_back((center + end + radius * normal).cast<float>());
      mesh.normals.push_back(normal.cast<float>());
    }
  }
  const auto at = [&](int r, int s) {
    return static_cast<std::uint32_t>(r * segments + s % segments);
  };
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
      mesh.triangles.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    }
  }
  return mesh;
}

inline Mesh sphere(const Eigen::Vector3d& center, double radius, int segments = 96) {
  return capsule(center, radius, 0, segments);
}

// Both meshes in one.
inline Mesh joined(Mesh a, const Mesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  for (const Triangle& t : b.triangles) {
    a.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return a;
}

}  // namespace graspdb::testing
