// SPDX-License-Identifier: MIT
#include "graspdb/geometry/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <tuple>

#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

std::vector<TriangleSide> sides_by_edge(std::span<const Triangle> triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, i, from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) <
           std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

bool is_one_piece(const std::vector<std::vector<std::uint32_t>>& neighbors) {
  std::vector<bool> seen(neighbors.size());
  std::vector<std::uint32_t> open = {0};
  std::size_t count = 0;
  while (!open.empty()) {
    const std::uint32_t v = open.back();
    open.pop_back();
    if (seen[v]) continue;
    seen[v] = true;
    ++count;
    open.insert(open.end(), neighbors[v].begin(), neighbors[v].end());
  }
  return count == neighbors.size();
}

}  // namespace

void for_each_edge(std::span<const Triangle> triangles, const std::function<void(Edge)>& visit) {
  const std::vector<TriangleSide> sides = sides_by_edge(triangles);
  for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
    end = std::find_if(begin, sides.end(), [&](const TriangleSide& side) {
      return side.low != begin->low || side.high != begin->high;
    });
    visit(Edge(begin, end));
  }
}

EdgeCounts count_edges(std::span<const Triangle> triangles) {
  EdgeCounts counts;
  for_each_edge(triangles, [&](Edge edge) {
    ++counts.all;
    counts.open += edge.size() == 1;
    counts.crowded += edge.size() > 2;
    counts.turned += edge.size() == 2 && edge[0].upwards == edge[1].upwards;
  });
  return counts;
}

std::size_t count_repeated(std::span<const Triangle> triangles) {
  std::vector<Triangle> sorted(triangles.begin(), triangles.end());
  for (Triangle& t : sorted) std::ranges::sort(t);
  std::ranges::sort(sorted);
  const auto [first, last] = std::ranges::unique(sorted);
  return static_cast<std::size_t>(last - first);
}

bool is_closed(std::span<const Triangle> triangles) {
  const EdgeCounts edges = count_edges(triangles);
  return edges.open == 0 && edges.crowded == 0;
}

bool is_sphere_like(std::size_t vertex_count, std::span<const Triangle> triangles) {
  const EdgeCounts edges = count_edges(triangles);
  return edges.open + edges.crowded + edges.turned == 0 &&
         vertex_count + triangles.size() == edges.all + 2 &&
         is_one_piece(vertex_neighbors(vertex_count, triangles));
}

std::vector<std::vector<std::uint32_t>> vertex_neighbors(std::size_t vertex_count,
                                                         std::span<const Triangle> triangles) {
  std::vector<std::vector<std::uint32_t>> neighbors(vertex_count);
  for (const Triangle& t : triangles) {
    // In a closed mesh every edge comes once in each direction.
    for (std::size_t i = 0; i < 3; ++i) neighbors[t[i]].push_back(t[(i + 1) % 3]);
  }
  return neighbors;
}

Mesh welded(const Mesh& mesh) {
  using Point = std::tuple<float, float, float>;
  Mesh result;
  std::map<Point, std::uint32_t> known;
  std::vector<std::uint32_t> index;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    const auto next = static_cast<std::uint32_t>(result.vertices.size());
    const auto [place, is_new] = known.try_emplace(Point(v.x(), v.y(), v.z()), next);
    if (is_new) result.vertices.push_back(v);
    index.push_back(place->second);
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle w = {index[t[0]], index[t[1]], index[t[2]]};
    if (has_three_corners(w)) result.triangles.push_back(w);
  }
  return result;
}

bool has_three_corners(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

double volume_of(const Mesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, t);
    volume += a.dot(b.cross(c)) / 6;
  }
  return volume;
}

}  // namespace graspdb
