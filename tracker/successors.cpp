// SPDX-License-Identifier: MIT
#include "successors.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "graspdb/core/error.h"
#include "graspdb/hand/label.h"

namespace graspdb {
namespace {

// Of 648 views those within 44 degrees: the next directions and the next turns about the line of
// sight.
constexpr std::size_t kNearViews = 16;

std::vector<Eigen::Matrix3d> view_rotations(const Database& database) {
  std::vector<Eigen::Matrix3d> rotations;
  const auto views = static_cast<std::uint32_t>(database.info().views);
  for (std::uint32_t row = 0; row < views; ++row) {
    const auto label = database.label(row);
    if (!is_finite(label))
      throw Error({database.path().string(), fmt::format("row {}", row), "finite labels",
                   "an altered row: see `graspdb verify`"});
    rotations.push_back(unpack_label(label).rotation);
  }
  return rotations;
}

std::vector<std::uint32_t> nearest_views(const std::vector<Eigen::Matrix3d>& views,
                                         const Eigen::Matrix3d& to) {
  std::vector<double> distance;  // grows with the angle between them
  for (const Eigen::Matrix3d& view : views) distance.push_back((view - to).squaredNorm());
  std::vector<std::uint32_t> order(views.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::size_t count = std::min(kNearViews, views.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(distance[a], a) < std::pair(distance[b], b);
                    });
  order.resize(count);
  return order;
}

}  // namespace

Successors::Successors(const Database& database)
    : views_(static_cast<std::uint32_t>(database.info().views)),
      steps_(static_cast<std::uint32_t>(database.info().steps)) {
  if (database.rows() == 0 || database.rows() % (std::size_t{views_} * steps_) != 0)
    throw Error({.file = database.path().string(),
                 .expected = fmt::format("{} steps x {} views of each grasp", steps_, views_),
                 .found = fmt::format("{} rows", database.rows())});
  const std::vector<Eigen::Matrix3d> views = view_rotations(database);
  for (const Eigen::Matrix3d& view : views) near_views_.push_back(nearest_views(views, view));
}

void Successors::append(std::uint32_t row, std::vector<std::uint32_t>& rows) const {
  const std::uint32_t pose = row / views_, step = pose % steps_;
  const std::uint32_t first = step == 0 ? pose : pose - 1;
  const std::uint32_t last = step + 1 == steps_ ? pose : pose + 1;
  for (std::uint32_t near_pose = first; near_pose <= last; ++near_pose) {
    for (const std::uint32_t view : near_views_[row % views_])
      rows.push_back(near_pose * views_ + view);
  }
}

}  // namespace graspdb
