// SPDX-License-Identifier: MIT
// The exact distance to a closed triangle mesh.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "graspdb/core/mesh.h"
#include "graspdb/geometry/triangle.h"

namespace graspdb {

// Signed by the angle-weighted normal of the nearest face, edge or corner (Baerentzen, Aanaes
// 2005), which is right everywhere for a surface that does not cut itself. Immutable, thread-safe.
class MeshDistance {
 public:
  // The mesh must be closed by index and not empty; its normals are not used.
  explicit MeshDistance(const Mesh& mesh);

  struct Nearest {
    double distance = 0;  // metres, negative inside
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
  };
  // The surface is known to be at most `bound` away; a good bound saves most of the time.
  Nearest nearest(const Eigen::Vector3d& point,
                  double bound = std::numeric_limits<double>::infinity()) const;

 private:
  struct Surroundings {
    Triangle vertices;
    std::array<std::uint32_t, 3> neighbors;  // the triangle beyond the side from corner i on
  };
  // An inner node has its two halves at `first` and `first + 1`, a leaf (`count` > 0) its
  // triangles.
  struct Node {
    Eigen::AlignedBox3f box;
    std::uint32_t first = 0, count = 0;
  };
  // Like the boxes in the mesh's own precision: a search of many triangles waits for memory.
  using StoredCorners = std::array<Eigen::Vector3f, 3>;

  // `places` are those of the mesh's triangles in the tree.
  void find_surroundings(const Mesh& mesh, std::span<const std::uint32_t> places);
  void split(std::uint32_t node, std::uint32_t begin, std::span<std::uint32_t> part);
  Corners corners(std::uint32_t triangle) const;
  Eigen::Vector3d face_normal(std::uint32_t triangle) const;
  Eigen::Vector3d normal(std::uint32_t triangle, NearestOnTriangle::Part part) const;

  std::vector<StoredCorners> triangles_;
  std::vector<Surroundings> surroundings_;  // apart: a search looks at many corners and one normal
  std::vector<Eigen::Vector3d> vertex_normals_;
  std::vector<Node> nodes_;
};

}  // namespace graspdb
