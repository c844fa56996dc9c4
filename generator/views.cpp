// SPDX-License-Identifier: MIT
#include "graspdb/generator/views.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// Points of a spherical Fibonacci lattice. None is at a pole, where a roll has no beginning.
Eigen::Vector3d fibonacci_direction(int index, int count) {
  const double golden_turn = (std::sqrt(5.0) - 1) / 2;
  const double z = 1 - (2.0 * index + 1) / count;
  const double longitude = 2 * kPi * golden_turn * (index + 0.5);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(longitude), radius * std::sin(longitude), z};
}

}  // namespace

std::vector<Eigen::Matrix3d> rolled_directions(int directions, int count) {
  GRASPDB_CHECK(directions > 0 && directions <= count);
  const auto first_of = [&](int direction) {
    return static_cast<int>(std::int64_t{direction} * count / directions);
  };
  std::vector<Eigen::Matrix3d> rotations;
  rotations.reserve(static_cast<std::size_t>(count));
  for (int direction = 0; direction < directions; ++direction) {
    const Eigen::Matrix3d camera_from_hand =
        rotation_between(fibonacci_direction(direction, directions), Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    const int rolls = first_of(direction + 1) - first_of(direction);
    for (int roll = 0; roll < rolls; ++roll) {
      rotations.emplace_back(axis_rotation(2, 2 * kPi * roll / rolls) * camera_from_hand);
    }
  }
  return rotations;
}

std::vector<Eigen::Matrix3d> view_rotations(int count) {
  GRASPDB_CHECK(count > 0);
  // As far from one direction to the next as from one roll to the next; the factor is measured.
  const long directions = std::lround(0.72 * std::pow(count, 2.0 / 3));
  return rolled_directions(static_cast<int>(std::max(directions, 1L)), count);
}

}  // namespace graspdb
