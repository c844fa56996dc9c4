// SPDX-License-Identifier: MIT
#include "graspdb/geometry/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

void for_each_side(std::span<const Triangle> triangles, const auto& visit) {
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      visit(TriangleSide{std::min(from, to), std::max(from, to), t, i, from < to});
    }
  }
}

// Those of one `low` are few: they are brought together by counting, and only then sorted.
std::vector<TriangleSide> sides_by_edge(std::span<const Triangle> triangles) {
  std::uint32_t last = 0;
  for (const Triangle& t : triangles) last = std::max(last, std::ranges::max(t));
  std::vector<std::size_t> place(std::size_t{last} + 2);  // of the next side of each `low`
  for_each_side(triangles, [&](const TriangleSide& side) { ++place[side.low + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<TriangleSide> sides(3 * triangles.size());
  for_each_side(triangles, [&](const TriangleSide& side) { sides[place[side.low]++] = side; });
  auto begin = sides.begin();
  for (const std::size_t end : place) {
    const auto next = sides.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(begin, next, [](const TriangleSide& a, const TriangleSide& b) {
      return std::tie(a.high, a.triangle, a.corner) < std::tie(b.high, b.triangle, b.corner);
    });
    begin = next;
  }
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

// For each vertex the one of the lowest number that lies where it does.
std::vector<std::uint32_t> first_at_their_place(std::span<const Eigen::Vector3f> vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::uint32_t v) {
    return std::tuple(vertices[v].x(), vertices[v].y(), vertices[v].z());
  };
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple_cat(place(a), std::tuple(a)) < std::tuple_cat(place(b), std::tuple(b));
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
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
  const auto last = std::unique(sorted.begin(), sorted.end());
  return static_cast<std::size_t>(sorted.end() - last);
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
  const std::vector<std::uint32_t> first = first_at_their_place(mesh.vertices);
  Mesh result;
  std::vector<std::uint32_t> index(first.size());
  for (std::size_t v = 0; v < first.size(); ++v) {
    index[v] = first[v] == v ? static_cast<std::uint32_t>(result.vertices.size()) : index[first[v]];
    if (first[v] == v) result.vertices.push_back(mesh.vertices[v]);
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
