// SPDX-License-Identifier: MIT
#include "subdivide.h"

#include <algorithm>

#include "graspdb/geometry/topology.h"

namespace graspdb {
namespace {

constexpr float kRoundness = .75F;  // as in the paper; 0 is flat

// The middle of an edge between the tangent planes of its ends.
Eigen::Vector3f curved_middle(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const Eigen::Vector3f middle = .5F * (mesh.vertices[a] + mesh.vertices[b]);
  Eigen::Vector3f onto_planes = Eigen::Vector3f::Zero();
  for (const std::uint32_t v : {a, b}) {
    const Eigen::Vector3f& normal = mesh.normals[v];
    onto_planes += .5F * (middle - normal * normal.dot(middle - mesh.vertices[v]));
  }
  return middle + kRoundness * (onto_planes - middle);
}

struct LongEdge {
  float length;
  std::uint32_t a, b;
  std::vector<std::uint32_t> triangles;
};

std::vector<LongEdge> long_edges(double limit, const Mesh& mesh) {
  std::vector<LongEdge> edges;
  for_each_edge(mesh.triangles, [&](Edge edge) {
    const auto [low, high] = std::pair(edge.front().low, edge.front().high);
    const float length = (mesh.vertices[low] - mesh.vertices[high]).norm();
    if (!(length > limit)) return;
    edges.push_back({length, low, high, {}});
    for (const TriangleSide& side : edge) edges.back().triangles.push_back(side.triangle);
  });
  std::stable_sort(edges.begin(), edges.end(),
                   [](const LongEdge& p, const LongEdge& q) { return p.length > q.length; });
  return edges;
}

// Puts `middle` in place of one end of the edge in a triangle, and of the other in a new one.
void halve(std::uint32_t triangle, const LongEdge& edge, std::uint32_t middle, Mesh& mesh) {
  Triangle second = mesh.triangles[triangle];
  for (std::uint32_t& v : mesh.triangles[triangle]) v = v == edge.a ? middle : v;
  for (std::uint32_t& v : second) v = v == edge.b ? middle : v;
  mesh.triangles.push_back(second);
}

}  // namespace

std::uint32_t add_midpoint(std::uint32_t a, std::uint32_t b, RigSkin& skin) {
  Mesh& mesh = skin.mesh;
  PerBone<double> weights;
  for (std::size_t i = 0; i < kBoneCount; ++i) {
    weights[i] = .5 * (skin.weights[a][i] + skin.weights[b][i]);
  }
  skin.weights.push_back(weights);
  mesh.vertices.push_back(.5F * (mesh.vertices[a] + mesh.vertices[b]));
  mesh.normals.push_back((mesh.normals[a] + mesh.normals[b]).normalized());
  mesh.albedo.push_back(.5F * (mesh.albedo[a] + mesh.albedo[b]));
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void subdivide(double longest_edge, RigSkin& skin) {
  while (true) {
    const std::vector<LongEdge> edges = long_edges(longest_edge, skin.mesh);
    if (edges.empty()) return;
    // A triangle is halved once a round, across the longest of its edges that are left.
    std::vector<bool> halved(skin.mesh.triangles.size());
    for (const LongEdge& edge : edges) {
      const auto is_halved = [&](std::uint32_t t) { return bool{halved[t]}; };
      if (std::any_of(edge.triangles.begin(), edge.triangles.end(), is_halved)) continue;
      const std::uint32_t middle = add_midpoint(edge.a, edge.b, skin);
      skin.mesh.vertices[middle] = curved_middle(skin.mesh, edge.a, edge.b);
      for (const std::uint32_t t : edge.triangles) {
        halve(t, edge, middle, skin.mesh);
        halved[t] = true;
      }
    }
  }
}

}  // namespace graspdb
