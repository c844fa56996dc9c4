// SPDX-License-Identifier: MIT
#include "graspdb/geometry/inside.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/geometry/triangle.h"

namespace graspdb {
namespace {

constexpr double kLargestCell = 0.001;   // metres
constexpr double kTrianglesInACell = 8;  // about, of many small ones

// Adds the middles of the longest edges until none is longer than `spacing`.
void split(const Corners& c, double spacing, std::vector<Eigen::Vector3d>& points) {
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double edge = (c[(i + 1) % 3] - c[i]).norm();
    if (edge > length) length = edge, longest = i;
  }
  if (length <= spacing) return;
  const Eigen::Vector3d& a = c[longest];
  const Eigen::Vector3d& b = c[(longest + 1) % 3];
  const Eigen::Vector3d& apex = c[(longest + 2) % 3];
  points.push_back((a + b) / 2);
  const Eigen::Vector3d middle = points.back();
  split({a, middle, apex}, spacing, points);
  split({middle, b, apex}, spacing, points);
}

// Van Oosterom, Strackee 1983.
double solid_angle(const Eigen::Vector3d& p, const Corners& corner) {
  const Eigen::Vector3d a = corner[0] - p, b = corner[1] - p, c = corner[2] - p;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)),
                        la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Where the line through a point along z meets a triangle.
struct Crossing {
  double height = 0;  // above the point
  int sign = 0;       // +1 where the line, going up, leaves, -1 where it enters; 0: it misses
};

Crossing crossing(const Eigen::Vector3d& p, const Corners& c) {
  std::array<double, 3> weight;
  for (std::size_t i = 0; i < 3; ++i) {
    weight[i] = cross2((c[(i + 1) % 3] - p).head<2>(), (c[(i + 2) % 3] - p).head<2>());
  }
  const bool up = weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0;
  const bool down = weight[0] <= 0 && weight[1] <= 0 && weight[2] <= 0;
  const double sum = weight[0] + weight[1] + weight[2];
  if ((!up && !down) || sum == 0) return {};
  const double z = (weight[0] * c[0].z() + weight[1] * c[1].z() + weight[2] * c[2].z()) / sum;
  return {z - p.z(), up ? 1 : -1};
}

}  // namespace

std::vector<Eigen::Vector3d> surface_points(const Mesh& mesh, double spacing) {
  GRASPDB_CHECK(spacing > 0);
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& vertex : mesh.vertices) points.push_back(vertex.cast<double>());
  for (const Triangle& triangle : mesh.triangles)
    split(corners_of(mesh, triangle), spacing, points);
  return points;
}

double distance_to_triangles(const Mesh& mesh, std::span<const Triangle> triangles,
                             const Eigen::Vector3d& point, double limit, double enough) {
  double nearest = limit;
  for (const Triangle& triangle : triangles) {
    if (nearest <= enough) break;
    const Corners c = corners_of(mesh, triangle);
    const double reach = std::max((c[1] - c[0]).norm(), (c[2] - c[0]).norm());
    if ((c[0] - point).norm() - reach >= nearest) continue;
    nearest = std::min(nearest, distance_to_triangle(point, c));
  }
  return nearest;
}

double winding_number(const Mesh& mesh, std::span<const Triangle> triangles,
                      const Eigen::Vector3d& point) {
  double sum = 0;
  for (const Triangle& triangle : triangles) sum += solid_angle(point, corners_of(mesh, triangle));
  return sum / (4 * kPi);
}

InsideTest::InsideTest(const Mesh& mesh) : mesh_(mesh) {
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e9);
  low_ = -high;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    low_ = low_.cwiseMin(v.head<2>().cast<double>());
    high = high.cwiseMax(v.head<2>().cast<double>());
  }
  const Eigen::Vector2d size = (high - low_).cwiseMax(kLargestCell);
  const double share = kTrianglesInACell / static_cast<double>(mesh.triangles.size() + 1);
  cell_size_ = std::min(kLargestCell, std::sqrt(size.prod() * share));
  columns_ = static_cast<int>((high.x() - low_.x()) / cell_size_) + 1;
  rows_ = static_cast<int>((high.y() - low_.y()) / cell_size_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners_of(mesh, mesh.triangles[t]);
    const Eigen::Vector3d from = c[0].cwiseMin(c[1]).cwiseMin(c[2]);
    const Eigen::Vector3d to = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
    for (int y = column(from.y(), 1); y <= column(to.y(), 1); ++y) {
      for (int x = column(from.x(), 0); x <= column(to.x(), 0); ++x) {
        cells_[cell(x, y)].push_back(t);
      }
    }
  }
}

std::size_t InsideTest::cell(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(x);
}

int InsideTest::column(double value, int axis) const {
  return static_cast<int>(std::floor((value - low_[axis]) / cell_size_));
}

double InsideTest::depth_along_z(const Eigen::Vector3d& at) const {
  // Aside by a thousandth of a millimetre: a line through a vertex would count several triangles.
  const Eigen::Vector3d point = at + Eigen::Vector3d(1.03e-6, 0.77e-6, 0);
  const int x = column(point.x(), 0), y = column(point.y(), 1);
  if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return 0;
  int leaving = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : cells_[cell(x, y)]) {
    const auto [height, sign] = crossing(point, corners_of(mesh_, mesh_.triangles[t]));
    if (sign == 0) continue;
    if (height > 0) leaving += sign;
    nearest = std::min(nearest, std::abs(height));
  }
  return leaving > 0 ? nearest : 0;
}

}  // namespace graspdb
