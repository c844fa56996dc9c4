// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <set>
#include <utility>

#include "graspdb/core/mesh.h"

namespace graspdb::testing {

// Every edge belongs to two triangles that run it in opposite directions, every vertex to one.
inline bool is_closed_surface(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::set<std::uint32_t> used;
  for (const Triangle& t : mesh.triangles) {
    used.insert(t.begin(), t.end());
    for (std::size_t i = 0; i < 3; ++i) {
      if (!edges.emplace(t[i], t[(i + 1) % 3]).second) return false;
    }
  }
  for (const auto& [from, to] : edges) {
    if (!edges.contains({to, from})) return false;
  }
  return !edges.empty() && used.size() == mesh.vertices.size();
}

// Cubic metres.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.vertices[t[i]].cast<double>().eval(); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

}  // namespace graspdb::testing
