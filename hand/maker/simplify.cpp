// SPDX-License-Identifier: MIT
#include "simplify.h"

#include <Eigen/Dense>
#include <algorithm>
#include <queue>

#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

using Index = std::uint32_t;

struct Collapse {
  double cost;
  Index keep, drop;
  std::uint32_t stamp;  // sum of both vertices' versions: older entries are stale
  Eigen::Vector3d position;

  bool operator<(const Collapse& other) const {  // the cheapest is the queue's top
    return std::tie(other.cost, other.keep, other.drop) < std::tie(cost, keep, drop);
  }
};

// Among collapses of equal error the shorter edge goes first, which keeps triangles even.
constexpr double kLengthWeight = 2e-3;
constexpr double kLongestEdgeMm = 9;
constexpr double kWorstQuality = .3;

class Simplifier {
 public:
  Simplifier(const RawMesh& mesh, const std::vector<bool>& kept)
      : kept_(kept),
        vertices_(mesh.vertices),
        triangles_(mesh.triangles),
        triangles_of_(vertices_.size()),
        quadrics_(vertices_.size(), Eigen::Matrix4d::Zero()),
        version_(vertices_.size(), 0),
        alive_(triangles_.size(), true) {
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (const Index v : triangles_[t]) triangles_of_[v].push_back(t);
      add_quadric(triangles_[t]);
    }
    for (Index v = 0; v < vertices_.size(); ++v) queue_edges(v, v);
  }

  RawMesh reduce_to(std::size_t count) {
    std::size_t left = triangles_.size();
    while (left > count && !queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      if (next.stamp != version_[next.keep] + version_[next.drop] || !is_allowed(next)) continue;
      apply(next);
      left -= 2;
    }
    return compacted();
  }

 private:
  void add_quadric(const Triangle& t) {
    const Corners corners = {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    const Eigen::Vector3d cross = normal_of(corners), normal = cross.normalized();
    Eigen::Vector4d plane;
    plane << normal, -normal.dot(corners[0]);
    for (const Index v : t) quadrics_[v] += cross.norm() / 6 * plane * plane.transpose();
  }

  std::vector<Index> neighbors(Index v) const {
    std::vector<Index> found;
    for (const Index t : triangles_of_[v]) {
      for (const Index other : triangles_[t]) {
        if (other != v) found.push_back(other);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // The edges of `v` to vertices above `lowest`.
  void queue_edges(Index v, Index lowest) {
    for (const Index other : neighbors(v)) {
      if (other > lowest && !kept_[v] && !kept_[other])
        queue_edge(std::min(v, other), std::max(v, other));
    }
  }

  void queue_edge(Index a, Index b) {
    const Eigen::Matrix4d quadric = quadrics_[a] + quadrics_[b];
    const Eigen::Vector3d middle = (vertices_[a] + vertices_[b]) / 2;
    const double length = (vertices_[a] - vertices_[b]).norm();
    // Pulled lightly to the middle, so that flat places have one answer too.
    const double pull = 1e-3 * quadric.topLeftCorner<3, 3>().trace() + 1e-9;
    const Eigen::Matrix3d system =
        quadric.topLeftCorner<3, 3>() + pull * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d position =
        system.ldlt().solve(pull * middle - quadric.topRightCorner<3, 1>());
    const double error = position.homogeneous().dot(quadric * position.homogeneous());
    queue_.push({error + kLengthWeight * length * length * length, a, b, version_[a] + version_[b],
                 position});
  }

  // The link condition keeps the mesh a 2-manifold.
  bool is_allowed(const Collapse& c) const {
    const std::vector<Index> a = neighbors(c.keep), b = neighbors(c.drop);
    std::vector<Index> common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common.size() == 2 && fits(c, c.keep) && fits(c, c.drop);
  }

  bool fits(const Collapse& c, Index moved) const {
    for (const Index t : triangles_of_[moved]) {
      Corners before, after;
      int of_edge = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = triangles_[t][i];
        before[i] = after[i] = vertices_[v];
        if (v == moved) after[i] = c.position;
        of_edge += v == c.keep || v == c.drop;
      }
      if (of_edge < 2 && !is_sound(before, after)) return false;
    }
    return true;
  }

  static bool is_sound(const Corners& before, const Corners& after) {
    return longest_side(after) < kLongestEdgeMm && quality_of(after) > kWorstQuality &&
           normal_of(after).normalized().dot(normal_of(before).normalized()) > .6;
  }

  void apply(const Collapse& c) {
    vertices_[c.keep] = c.position;
    quadrics_[c.keep] += quadrics_[c.drop];
    const std::vector<Index> moved = std::move(triangles_of_[c.drop]);
    triangles_of_[c.drop].clear();
    for (const Index t : moved) {
      Triangle& triangle = triangles_[t];
      if (std::find(triangle.begin(), triangle.end(), c.keep) != triangle.end()) {
        alive_[t] = false;
        for (const Index v : triangle) std::erase(triangles_of_[v], t);
      } else {
        std::replace(triangle.begin(), triangle.end(), c.drop, c.keep);
        triangles_of_[c.keep].push_back(t);
      }
    }
    ++version_[c.keep];
    ++version_[c.drop];
    queue_edges(c.keep, 0);
  }

  RawMesh compacted() const {
    RawMesh mesh;
    std::vector<Index> renumbered(vertices_.size());
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (triangles_of_[v].empty()) continue;
      renumbered[v] = static_cast<Index>(mesh.vertices.size());
      mesh.vertices.push_back(vertices_[v]);
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& from = triangles_[t];
      if (!alive_[t]) continue;
      mesh.triangles.push_back({renumbered[from[0]], renumbered[from[1]], renumbered[from[2]]});
    }
    return mesh;
  }

  const std::vector<bool>& kept_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index>> triangles_of_;
  std::vector<Eigen::Matrix4d> quadrics_;
  std::vector<std::uint32_t> version_;
  std::vector<bool> alive_;
  std::priority_queue<Collapse> queue_;
};

}  // namespace

RawMesh simplified(const RawMesh& mesh, std::size_t triangle_count, const std::vector<bool>& kept) {
  return Simplifier(mesh, kept).reduce_to(triangle_count);
}

}  // namespace graspdb
