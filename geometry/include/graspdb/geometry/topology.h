// SPDX-License-Identifier: MIT
// How the triangles of a mesh hang together, by the numbers of their vertices. The three corners of
// every triangle must be three vertices. Pure, thread-safe.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "graspdb/core/mesh.h"

namespace graspdb {

// One side of a triangle: from its corner `corner` to the next one.
struct TriangleSide {
  std::uint32_t low, high;  // its two vertices, the smaller number first
  std::uint32_t triangle;
  std::uint32_t corner;
  bool upwards;  // runs from `low` to `high`
};

// An edge is all sides between two vertices, in the order of their triangles. Never empty.
using Edge = std::span<const TriangleSide>;

// Visits every edge once, in the order of (low, high). An edge lasts as long as its visit.
void for_each_edge(std::span<const Triangle> triangles, const std::function<void(Edge)>& visit);

struct EdgeCounts {
  std::size_t all = 0;
  std::size_t open = 0;     // of one triangle
  std::size_t crowded = 0;  // of more than two
  std::size_t turned = 0;   // of two that do not face the same side
};
EdgeCounts count_edges(std::span<const Triangle> triangles);

// How many triangles have the three corners of one before them, in whatever order.
std::size_t count_repeated(std::span<const Triangle> triangles);

// Whether every edge has two triangles, so that they enclose a volume.
bool is_closed(std::span<const Triangle> triangles);

// Whether the triangles are closed, face one side, use every vertex, and are of one piece without
// handles.
bool is_sphere_like(std::size_t vertex_count, std::span<const Triangle> triangles);

// Of a closed mesh: the vertices that share an edge with each one, in the order of the triangles.
std::vector<std::vector<std::uint32_t>> vertex_neighbors(std::size_t vertex_count,
                                                         std::span<const Triangle> triangles);

// The surface alone, without normals and albedo: vertices at one place are one, and triangles that
// have lost a corner by that are gone.
Mesh welded(const Mesh& mesh);

// Whether no two corners are one vertex.
bool has_three_corners(const Triangle& triangle);

// Of a closed mesh, in its unit cubed; negative when the triangles face inwards.
double volume_of(const Mesh& mesh);

}  // namespace graspdb
