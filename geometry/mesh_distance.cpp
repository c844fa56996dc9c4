// SPDX-License-Identifier: MIT
#include "graspdb/geometry/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graspdb/core/error.h"
#include "graspdb/geometry/topology.h"

namespace graspdb {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kStackSize = 64;  // every split halves: enough for 2^60 triangles

double angle_at(const Eigen::Vector3d& apex, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2((a - apex).cross(b - apex).norm(), (a - apex).dot(b - apex));
}

double distance2(const Eigen::AlignedBox3f& box, const Eigen::Vector3d& point) {
  const Eigen::Vector3d low = box.min().cast<double>(), high = box.max().cast<double>();
  return (low - point).cwiseMax(point - high).cwiseMax(0).squaredNorm();
}

}  // namespace

MeshDistance::MeshDistance(const Mesh& mesh) {
  GRASPDB_CHECK(!mesh.triangles.empty());
  const auto stored = [&](const Triangle& t) {
    return StoredCorners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
  };
  for (const Triangle& t : mesh.triangles) triangles_.push_back(stored(t));
  std::vector<std::uint32_t> order(triangles_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  nodes_.emplace_back();
  split(0, 0, order);
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) places[order[i]] = i;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    triangles_[i] = stored(mesh.triangles[order[i]]);
  }
  find_surroundings(mesh, places);
}

// Only the direction of normals matters, so sums stand for means.
void MeshDistance::find_surroundings(const Mesh& mesh, std::span<const std::uint32_t> places) {
  surroundings_.resize(triangles_.size());
  vertex_normals_.resize(mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (std::size_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const Corners c = corners(places[f]);
    const Eigen::Vector3d normal = face_normal(places[f]);
    for (std::size_t i = 0; i < 3; ++i) {
      vertex_normals_[t[i]] += angle_at(c[i], c[(i + 1) % 3], c[(i + 2) % 3]) * normal;
    }
    surroundings_[places[f]].vertices = t;
  }
  for_each_edge(mesh.triangles, [&](Edge edge) {
    for (const TriangleSide& side : edge) {
      const TriangleSide& other =
          side.triangle == edge.front().triangle ? edge.back() : edge.front();
      surroundings_[places[side.triangle]].neighbors[side.corner] = places[other.triangle];
    }
  });
}

Corners MeshDistance::corners(std::uint32_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle];
  return {a.cast<double>(), b.cast<double>(), c.cast<double>()};
}

Eigen::Vector3d MeshDistance::face_normal(std::uint32_t triangle) const {
  return normal_of(corners(triangle)).normalized();
}

// `part` is of the triangles' order, from `begin` on.
void MeshDistance::split(std::uint32_t node, std::uint32_t begin, std::span<std::uint32_t> part) {
  Eigen::AlignedBox3f box;
  Eigen::AlignedBox3d middles;
  const auto middle = [this](std::uint32_t t) {
    const Corners c = corners(t);
    return Eigen::Vector3d(c[0] + c[1] + c[2]);
  };
  for (const std::uint32_t t : part) {
    for (const Eigen::Vector3f& corner : triangles_[t]) box.extend(corner);
    middles.extend(middle(t));
  }
  nodes_[node].box = box;
  if (part.size() <= kLeafSize) {
    nodes_[node].first = begin;
    nodes_[node].count = static_cast<std::uint32_t>(part.size());
    return;
  }
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const auto half = static_cast<std::uint32_t>(part.size() / 2);
  std::nth_element(part.begin(), part.begin() + half, part.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return std::pair(middle(a)[axis], a) < std::pair(middle(b)[axis], b);
                   });
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = first;
  nodes_.resize(nodes_.size() + 2);
  split(first, begin, part.first(half));
  split(first + 1, begin + half, part.subspan(half));
}

Eigen::Vector3d MeshDistance::normal(std::uint32_t triangle, NearestOnTriangle::Part part) const {
  if (part == NearestOnTriangle::kInside) return face_normal(triangle);
  const Surroundings& around = surroundings_[triangle];
  const auto index = static_cast<std::size_t>(part);
  if (index < 3) return vertex_normals_[around.vertices[index]];
  return face_normal(triangle) + face_normal(around.neighbors[index - 3]);
}

MeshDistance::Nearest MeshDistance::nearest(const Eigen::Vector3d& point, double bound) const {
  constexpr double kSlack = 1e-9;  // a bound that is met exactly must still find its triangle
  double nearest2 = (bound + kSlack) * (bound + kSlack);
  NearestOnTriangle nearest{point, NearestOnTriangle::kInside};
  std::uint32_t triangle = 0;
  std::array<std::pair<double, std::uint32_t>, kStackSize> open;  // squared distance, node
  std::size_t count = 0;
  open[count++] = {distance2(nodes_[0].box, point), 0};
  while (count > 0) {
    const auto [away2, index] = open[--count];
    if (away2 >= nearest2) continue;
    const Node& node = nodes_[index];
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const NearestOnTriangle found = nearest_on_triangle(point, corners(t));
      const double found2 = (point - found.point).squaredNorm();
      if (found2 < nearest2) nearest2 = found2, nearest = found, triangle = t;
    }
    if (node.count > 0) continue;
    const double a = distance2(nodes_[node.first].box, point);
    const double b = distance2(nodes_[node.first + 1].box, point);
    // The nearer half is taken first.
    open[count++] = a < b ? std::pair(b, node.first + 1) : std::pair(a, node.first);
    open[count++] = a < b ? std::pair(a, node.first) : std::pair(b, node.first + 1);
  }
  const double side = normal(triangle, nearest.part).dot(point - nearest.point);
  return {std::copysign(std::sqrt(nearest2), side), nearest.point};
}

}  // namespace graspdb
