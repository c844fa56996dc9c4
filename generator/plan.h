// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graspdb/database/database.h"
#include "graspdb/features/embedding.h"
#include "graspdb/generator/build_config.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// A copy with or without its object.
struct Variant {
  bool holds;
  int copy;  // from 1; those of one number are varied alike

  std::string name() const;  // "held", "free", "held 2", ...
};

// The rows of one hand, variant and grasp: the unit that is kept and used again.
struct Shard {
  std::size_t hand, variant, grasp;  // ordinals in the plan
};

// Everything a build needs, loaded and checked, and the order of its rows.
struct Plan {
  BuildConfig config;       // with the hashes of its files
  std::vector<Hand> hands;  // with all of their forearms
  std::vector<Grasp> grasps;
  JointAngles rest;
  std::vector<std::vector<GraspPose>> closed;  // [hand][grasp ordinal]
  std::vector<Variant> variants;
  std::vector<Eigen::Matrix3d> views;       // camera_from_hand
  std::shared_ptr<const EmbeddingNet> net;  // null: rows have HOGs only

  std::vector<Shard> shards() const;  // in the order of their rows
  std::size_t rows_per_shard() const {
    return static_cast<std::size_t>(config.steps) * views.size();
  }
};

// `threads` as in parallel_for. Throws Error for bad input, and when the configuration's hashes are
// not those of its files.
Plan make_plan(const BuildConfig& config, int threads);

DatabaseInfo describe_plan(const Plan& plan);

// Of the database that one shard is by itself.
DatabaseInfo describe_shard(const Plan& plan, const Shard& shard);

}  // namespace graspdb
