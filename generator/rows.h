// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <tuple>

#include "graspdb/database/database.h"
#include "graspdb/generator/row_poses.h"
#include "plan.h"

namespace graspdb {

// A shard's grasp with its object in the size that it has there, and the hand closed on it.
struct SizedGrasp {
  Grasp grasp;
  GraspPose closed;
};

// Takes about a second where jitter changes the object's size, for the hand is closed again. The
// same for a copy's held and free rows. Thread-safe.
SizedGrasp sized_grasp(const Plan& plan, const Shard& shard);

// The same, made when first asked for and once for all variants of a copy. Thread-safe; the plan
// must outlive it.
class SizedGrasps {
 public:
  explicit SizedGrasps(const Plan& plan) : plan_(plan) {}
  const SizedGrasp& of(const Shard& shard);

 private:
  struct Entry {
    std::once_flag made;
    SizedGrasp grasp;
  };
  const Plan& plan_;
  std::mutex mutex_;
  std::map<std::tuple<std::size_t, std::size_t, int>, Entry> known_;  // hand, grasp, copy
};

// What all views of one step of a shard share, and what is each view's own. Pure and thread-safe.
RowPose pose_rows(const Plan& plan, const Shard& shard, const SizedGrasp& sized, int step);
Camera row_camera(const Plan& plan, const PosedScene& posed, std::size_t view);
Light row_light(const Plan& plan, const Shard& shard, std::size_t view);

// Renders and describes all views of one step of a shard: rows[i] becomes view i, as a row of a
// database of the shard alone (hand 0, variant 0). Pure and thread-safe. `heed` is called before
// each row; what it throws ends the work.
void make_rows(const Plan& plan, const Shard& shard, const SizedGrasp& sized, int step,
               std::span<Row> rows, const std::function<void()>& heed = {});

}  // namespace graspdb
