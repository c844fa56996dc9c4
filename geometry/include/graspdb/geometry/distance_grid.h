// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "graspdb/geometry/mesh_distance.h"

namespace graspdb {

// Distances to a mesh that are kept on a grid and read between its nodes, which is much faster than
// to search the mesh. Cells near the surface where that is not good enough (at sharp edges and in
// the middle of thin walls) say so. Immutable, thread-safe.
class DistanceGrid {
 public:
  // `cell` in metres; it grows for a box that would need more than two million nodes.
  // Further than `reach` from the surface it may take what `coarse` says.
  DistanceGrid(const MeshDistance& exact, const Eigen::AlignedBox3d& box, double cell,
               const DistanceGrid* coarse = nullptr, double reach = 0);

  bool contains(const Eigen::Vector3d& point) const { return box_.contains(point); }

  struct Reading {
    double distance = 0;
    bool is_rough = false;  // worse than 0.05 mm at the cell's middle
  };
  Reading at(const Eigen::Vector3d& point) const;  // of a point that it contains

 private:
  struct Place {
    std::size_t node = 0;  // of the cell's lowest corner
    Eigen::Vector3d share;
  };
  Place place(const Eigen::Vector3d& point) const;
  double interpolated(const Place& place) const;
  Eigen::Vector3d position(int x, int y, int z) const;
  void sample(const MeshDistance& exact, const DistanceGrid* coarse, double reach);
  void mark_rough(const MeshDistance& exact);

  Eigen::AlignedBox3d box_;
  double cell_;
  Eigen::Vector3i count_;  // of nodes
  std::vector<float> values_;
  std::vector<std::uint8_t> rough_;  // of the cell above each node
};

}  // namespace graspdb
