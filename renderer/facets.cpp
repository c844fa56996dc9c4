// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <limits>

#include "triangle_raster.h"

namespace graspdb {
namespace {

constexpr std::size_t kMostLanes = 16;

Eigen::Vector3f outward_normal(const Mesh& mesh, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3f& origin = mesh.vertices[a];
  return (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin);
}

// Against the skin around it, which the vertices' normals stand for.
bool is_turned_over(const Mesh& mesh, const Triangle& triangle, const Eigen::Vector3f& normal) {
  for (const std::uint32_t vertex : triangle) {
    if (normal.dot(mesh.normals[vertex]) < 0) return true;
  }
  return false;
}

void add(const Triangle& triangle, const Eigen::Vector3f& normal, float offset, Facets& facets) {
  facets.triangles.push_back(triangle);
  for (int i = 0; i < 3; ++i) facets.normal[static_cast<std::size_t>(i)].push_back(normal[i]);
  facets.offset.push_back(offset);
}

}  // namespace

Facets make_facets(const Mesh& mesh) {
  Facets facets;
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3f normal = outward_normal(mesh, triangle);
    const float offset = normal.dot(mesh.vertices[triangle[0]]);
    add(triangle, normal, offset, facets);
    if (!is_turned_over(mesh, triangle, normal)) continue;
    add({triangle[0], triangle[2], triangle[1]}, -normal, -offset, facets);
  }
  const std::size_t padded = (facets.offset.size() + kMostLanes - 1) / kMostLanes * kMostLanes;
  for (auto& coordinate : facets.normal) coordinate.resize(padded, 0.0F);
  facets.offset.resize(padded, std::numeric_limits<float>::infinity());
  return facets;
}

}  // namespace graspdb
