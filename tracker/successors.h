// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "graspdb/database/database.h"

namespace graspdb {

// Which rows show what a row may have become a frame later: the same hand in the same grasp, with
// or without the object as there, at its step, the one before or the one after, from its view or
// one of those next to it.
class Successors {
 public:
  // Throws Error for a database that is no grid of poses and views, or whose views are not finite.
  explicit Successors(const Database& database);

  // Adds them, `row` among them, in no particular order.
  void append(std::uint32_t row, std::vector<std::uint32_t>& rows) const;

 private:
  std::uint32_t views_, steps_;
  std::vector<std::vector<std::uint32_t>> near_views_;  // of each view, itself among them
};

}  // namespace graspdb
