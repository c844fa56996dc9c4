// SPDX-License-Identifier: MIT
// Exact tests of points against triangle meshes.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "graspdb/core/mesh.h"

namespace graspdb {

// Points that are at most `spacing` apart on every triangle, the corners among them.
std::vector<Eigen::Vector3d> surface_points(const Mesh& mesh, double spacing);

// The nearest distance to some of a mesh's triangles, metres; `limit` when all are further away,
// and any distance on the way there that is at most `enough`.
double distance_to_triangles(const Mesh& mesh, std::span<const Triangle> triangles,
                             const Eigen::Vector3d& point, double limit, double enough = 0);

// How often the triangles wind round the point: 1 inside a closed mesh, 0 outside; in between near
// the holes of an open one (Jacobson, Kavan, Sorkine-Hornung 2013).
double winding_number(const Mesh& mesh, std::span<const Triangle> triangles,
                      const Eigen::Vector3d& point);

// Answers whether points are inside a closed mesh, which may overlap itself, by counting the
// surfaces above them. Keeps a reference. Thread-safe.
class InsideTest {
 public:
  explicit InsideTest(const Mesh& mesh);
  // 0 outside; inside, how far the surface is along z, which is at least the depth.
  double depth_along_z(const Eigen::Vector3d& point) const;

 private:
  int column(double value, int axis) const;
  std::size_t cell(int x, int y) const;

  const Mesh& mesh_;
  Eigen::Vector2d low_;
  double cell_size_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;  // triangles by their shadow on the xy plane
};

}  // namespace graspdb
