// SPDX-License-Identifier: MIT
#include "graspdb/generator/row_poses.h"

#include <algorithm>

#include "graspdb/core/error.h"
#include "plan.h"
#include "rows.h"

namespace graspdb {
namespace {

std::size_t grasp_ordinal(const Plan& plan, int id) {
  const auto found = std::ranges::find(plan.grasps, id, &Grasp::id);
  GRASPDB_CHECK(found != plan.grasps.end());
  return static_cast<std::size_t>(found - plan.grasps.begin());
}

}  // namespace

struct RowPoses::State {
  explicit State(Plan loaded) : plan(std::move(loaded)) {}

  Shard shard_of(const PoseKey& key) const {
    GRASPDB_CHECK(key.hand < plan.hands.size() && key.variant < plan.variants.size());
    return {key.hand, key.variant, grasp_ordinal(plan, key.grasp)};
  }

  const Plan plan;
  SizedGrasps sized{plan};
};

RowPoses::RowPoses(const BuildConfig& config, int threads)
    : state_(std::make_unique<State>(make_plan(config, threads))) {}
RowPoses::~RowPoses() = default;
RowPoses::RowPoses(RowPoses&&) noexcept = default;
RowPoses& RowPoses::operator=(RowPoses&&) noexcept = default;

const BuildConfig& RowPoses::config() const {
  return state_->plan.config;
}

const Hand& RowPoses::hand(std::size_t ordinal) const {
  GRASPDB_CHECK(ordinal < state_->plan.hands.size());
  return state_->plan.hands[ordinal];
}

const Grasp& RowPoses::grasp(int id) const {
  return state_->plan.grasps[grasp_ordinal(state_->plan, id)];
}

RowPose RowPoses::pose(const PoseKey& key) const {
  const Plan& plan = state_->plan;
  GRASPDB_CHECK(key.step >= 1 && key.step <= plan.config.steps);
  const Shard shard = state_->shard_of(key);
  return pose_rows(plan, shard, state_->sized.of(shard), key.step);
}

Camera RowPoses::camera(const RowPose& pose, std::size_t view) const {
  GRASPDB_CHECK(view < state_->plan.views.size());
  return row_camera(state_->plan, pose.scene, view);
}

Light RowPoses::light(const PoseKey& key, std::size_t view) const {
  return row_light(state_->plan, state_->shard_of(key), view);
}

}  // namespace graspdb
