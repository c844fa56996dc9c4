// SPDX-License-Identifier: MIT
#include "graspdb/geometry/mesh_solid.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <mutex>
#include <optional>
#include <set>

#include "graspdb/core/error.h"
#include "graspdb/geometry/distance_grid.h"
#include "graspdb/geometry/inside.h"
#include "graspdb/geometry/mesh_distance.h"
#include "graspdb/geometry/topology.h"
#include "nearest_point.h"

namespace graspdb {
namespace {

constexpr double kSmallest = 1e-3, kLargest = 1;  // metres, of the longest side of its box
constexpr double kFineCell = 1e-3, kFineMargin = 6e-3, kFineReach = 5e-3;
constexpr double kCoarseCell = 4e-3, kCoarseMargin = 50e-3;
// Of so many triangles the nearest one takes long to tell from its neighbours. From kCoarseMargin
// away points that are kFarSpacing apart are as good: to 0.3 mm.
constexpr std::size_t kMany = 100000, kMost = 2000000;
constexpr double kFarSpacing = 3e-3;

Eigen::AlignedBox3d bounds(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& v : mesh.vertices) box.extend(v.cast<double>());
  return box;
}

// Triangles whose outer side is inside the solid, as those of two pieces that cut each other.
int buried_triangles(const Mesh& mesh) {
  constexpr double kAside = 1e-5;        // metres
  constexpr double kSmallHeight = 1e-4;  // too thin a triangle has no sure outer side
  const InsideTest inside(mesh);
  int buried = 0;
  for (const Triangle& t : mesh.triangles) {
    const Corners corners = corners_of(mesh, t);
    const Eigen::Vector3d normal = normal_of(corners);
    if (normal.norm() < longest_side(corners) * kSmallHeight) continue;
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    const Eigen::Vector3d outside = middle + kAside * normal.normalized();
    if (inside.depth_along_z(outside) > 0) ++buried;
  }
  return buried;
}

// `fail` takes what is expected and what is found.
template <typename Fail>
void require_closed(std::span<const Triangle> triangles, const Fail& fail) {
  const EdgeCounts edges = count_edges(triangles);
  const std::size_t repeated = edges.crowded > 0 ? count_repeated(triangles) : 0;
  if (repeated > 0) {
    fail("every triangle once",
         fmt::format("{} that are there again (a doubled or double-sided surface, or parts that "
                     "touch: join them)",
                     repeated));
  }
  if (edges.open > 0) fail("a watertight surface", fmt::format("{} open edges", edges.open));
  if (edges.crowded > 0) {
    fail("two triangles at every edge (parts that touch are to be joined)",
         fmt::format("{} edges with more", edges.crowded));
  }
  if (edges.turned > 0) {
    fail("a surface whose triangles all face outwards",
         fmt::format("{} edges where they disagree", edges.turned));
  }
}

void require_solid(const Mesh& surface, const std::filesystem::path& file) {
  const auto fail = [&](const char* expected, const std::string& found) {
    throw Error({.file = file.string(), .expected = expected, .found = found});
  };
  if (surface.triangles.empty()) fail("a surface of triangles", "none");
  if (surface.triangles.size() > kMost) {
    fail("at most 2,000,000 triangles (simplify the mesh)",
         fmt::format("{}", surface.triangles.size()));
  }
  const double size = bounds(surface).sizes().maxCoeff();
  if (!(size >= kSmallest && size <= kLargest)) {
    fail("an object of 1 to 1000 mm (is its unit right?)", fmt::format("{:.4g} mm", size * 1000));
  }
  require_closed(surface.triangles, fail);
  if (volume_of(surface) <= 0) fail("triangles that face outwards", "a surface turned inside out");
  if (const int buried = buried_triangles(surface); buried > 0) {
    fail("a surface that does not cut itself", fmt::format("{} triangles inside it", buried));
  }
}

// Points of a surface, about as far apart as `spacing`, also where its triangles are much smaller.
std::vector<Eigen::Vector3f> thinned_points(const Mesh& surface, double spacing) {
  std::set<std::array<int, 3>> taken;
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3d& point : surface_points(surface, spacing)) {
    const Eigen::Array3i cell = (point / spacing).array().floor().cast<int>();
    if (taken.insert({cell[0], cell[1], cell[2]}).second) points.push_back(point.cast<float>());
  }
  return points;
}

class MeshSolid final : public Solid {
 public:
  MeshSolid(Mesh drawn, const Mesh& surface)
      : mesh_(std::move(drawn)), half_(bounds(surface).sizes() / 2), exact_(surface) {
    if (surface.triangles.size() > kMany) far_.emplace(thinned_points(surface, kFarSpacing));
  }

  double distance(const Eigen::Vector3d& point) const override {
    std::call_once(sampled_, [this] { sample(); });
    if (fine_->contains(point)) {
      const DistanceGrid::Reading read = fine_->at(point);
      if (!read.is_rough) return read.distance;
      return exact_.nearest(point, std::abs(read.distance) + 2 * kFineCell).distance;
    }
    if (coarse_->contains(point)) return coarse_->at(point).distance;
    return far_ ? far_->distance(point) : exact_.nearest(point).distance;
  }
  Eigen::Vector3d half_extents() const override { return half_; }
  const Mesh& mesh() const override { return mesh_; }

 private:
  // Takes part of a second, and who only draws needs none of it.
  void sample() const {
    const auto around = [this](double margin) {
      const Eigen::Vector3d high = half_.array() + margin;
      return Eigen::AlignedBox3d(-high, high);
    };
    coarse_.emplace(exact_, around(kCoarseMargin), kCoarseCell);
    fine_.emplace(exact_, around(kFineMargin), kFineCell, &*coarse_, kFineReach);
  }

  Mesh mesh_;
  Eigen::Vector3d half_;
  MeshDistance exact_;
  std::optional<NearestPoint> far_;
  mutable std::once_flag sampled_;
  mutable std::optional<DistanceGrid> fine_, coarse_;
};

}  // namespace

std::shared_ptr<const Solid> make_mesh_solid(Mesh mesh, const std::filesystem::path& file) {
  const Eigen::Vector3f middle = bounds(mesh).center().cast<float>();
  for (Eigen::Vector3f& v : mesh.vertices) v -= middle;
  const Mesh surface = welded(mesh);
  require_solid(surface, file);
  return std::make_shared<MeshSolid>(std::move(mesh), surface);
}

}  // namespace graspdb
