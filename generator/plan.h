// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "graspdb/closing.h"
#include "graspdb/generator.h"
#include "graspdb/grasp.h"
#include "graspdb/hand.h"

namespace graspdb {

// Everything a build needs, loaded and checked, and the order of its rows.
struct Plan {
  BuildConfig config;
  std::vector<Hand> hands;
  std::vector<Grasp> grasps;
  JointAngles rest;
  std::vector<std::vector<GraspPose>> closed;  // [hand][grasp ordinal]
  std::vector<bool> variant_holds;             // per variant: is the object there
  std::vector<Eigen::Matrix3d> views;          // camera_from_hand

  // A pose is one (hand, variant, grasp, step); its rows are its views.
  struct Pose {
    std::size_t hand, variant, grasp;
    int step;
  };
  std::size_t pose_count() const;
  Pose pose(std::size_t index) const;
  std::size_t row_count() const { return pose_count() * views.size(); }
};

Plan make_plan(const BuildConfig& config);
DatabaseInfo describe_plan(const Plan& plan);

}  // namespace graspdb
