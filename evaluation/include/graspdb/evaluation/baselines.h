// SPDX-License-Identifier: MIT
// What frames with the same truth give without looking at the picture.
#pragma once

#include <cstdint>
#include <vector>

#include "graspdb/evaluation/metrics.h"
#include "graspdb/evaluation/pose_grid.h"

namespace graspdb {

struct GridPlace {
  std::size_t pose = 0, view = 0;
};

// Of one frame: for each metric the error of its own best row, seen where the true palm is.
struct FrameOracle {
  FrameErrors errors;
  GridPlace best_pose_error, best_mpjpe;  // rows that give them
};
// Exact: what is not looked at is provably worse.
FrameOracle oracle(const PoseGrid& grid, const Target& truth);

struct Baselines {
  std::vector<FrameOracle> oracle;  // a frame each
  Summary oracle_mean;              // its unsteadiness: of the rows that are best by mpjpe
  Summary random;                   // mean over random rows; types of grasp in random order
  Summary constant;  // the view and the pose that, kept all the time, are best for these frames
};
Baselines baselines(const PoseGrid& grid, const std::vector<Target>& truth, std::uint64_t seed);

}  // namespace graspdb
