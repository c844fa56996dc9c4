// SPDX-License-Identifier: MIT
#include "graspdb/geometry/distance_grid.h"

#include <algorithm>
#include <cmath>

namespace graspdb {
namespace {

constexpr double kMostNodes = 2e6;
constexpr double kNear = 3e-3;  // metres: what touches or nearly so must be right
constexpr double kTolerance = 0.05e-3;

}  // namespace

DistanceGrid::DistanceGrid(const MeshDistance& exact, const Eigen::AlignedBox3d& box, double cell,
                           const DistanceGrid* coarse, double reach)
    : box_(box), cell_(std::max(cell, std::cbrt(box.volume() / kMostNodes))) {
  count_ = (box.sizes() / cell_).array().ceil().cast<int>() + 1;
  values_.resize(static_cast<std::size_t>(count_.x()) * static_cast<std::size_t>(count_.y()) *
                 static_cast<std::size_t>(count_.z()));
  rough_.resize(values_.size());
  sample(exact, coarse, reach);
  mark_rough(exact);
}

Eigen::Vector3d DistanceGrid::position(int x, int y, int z) const {
  return box_.min() + cell_ * Eigen::Vector3d(x, y, z);
}

void DistanceGrid::sample(const MeshDistance& exact, const DistanceGrid* coarse, double reach) {
  std::size_t node = 0;
  Eigen::Vector3d seen = exact.nearest(box_.min()).point;  // of the surface, and near the next node
  for (int z = 0; z < count_.z(); ++z) {
    for (int y = 0; y < count_.y(); ++y) {
      for (int x = 0; x < count_.x(); ++x) {
        const Eigen::Vector3d p = position(x, y, z);
        double distance = coarse != nullptr ? coarse->at(p).distance : 0;
        if (std::abs(distance) <= reach) {
          const MeshDistance::Nearest found = exact.nearest(p, (p - seen).norm());
          distance = found.distance;
          seen = found.point;
        }
        values_[node++] = static_cast<float>(distance);
      }
    }
  }
}

void DistanceGrid::mark_rough(const MeshDistance& exact) {
  Eigen::Vector3d seen = exact.nearest(box_.min()).point;
  for (int z = 0; z + 1 < count_.z(); ++z) {
    for (int y = 0; y + 1 < count_.y(); ++y) {
      for (int x = 0; x + 1 < count_.x(); ++x) {
        const Eigen::Vector3d middle = position(x, y, z) + Eigen::Vector3d::Constant(cell_ / 2);
        const Place at = place(middle);
        const double read = interpolated(at);
        if (std::abs(read) > kNear + cell_ / 2) continue;
        const MeshDistance::Nearest found = exact.nearest(middle, (middle - seen).norm());
        rough_[at.node] = std::abs(found.distance - read) > kTolerance ? 1 : 0;
        seen = found.point;
      }
    }
  }
}

DistanceGrid::Place DistanceGrid::place(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d at = (point - box_.min()) / cell_;
  const Eigen::Vector3i low =
      at.cast<int>().cwiseMin(count_.array().matrix() - Eigen::Vector3i(2, 2, 2));
  const auto columns = static_cast<std::size_t>(count_.x());
  const auto rows = static_cast<std::size_t>(count_.y());
  const std::size_t node =
      static_cast<std::size_t>(low.x()) +
      columns * (static_cast<std::size_t>(low.y()) + rows * static_cast<std::size_t>(low.z()));
  return {node, at - low.cast<double>()};
}

double DistanceGrid::interpolated(const Place& at) const {
  const std::size_t up_y = static_cast<std::size_t>(count_.x());
  const std::size_t up_z = up_y * static_cast<std::size_t>(count_.y());
  const auto along_x = [&](std::size_t node) {
    return values_[node] + at.share.x() * (values_[node + 1] - values_[node]);
  };
  const auto along_xy = [&](std::size_t node) {
    return std::lerp(along_x(node), along_x(node + up_y), at.share.y());
  };
  return std::lerp(along_xy(at.node), along_xy(at.node + up_z), at.share.z());
}

DistanceGrid::Reading DistanceGrid::at(const Eigen::Vector3d& point) const {
  const Place where = place(point);
  return {interpolated(where), rough_[where.node] != 0};
}

}  // namespace graspdb
