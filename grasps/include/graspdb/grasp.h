// SPDX-License-Identifier: MIT
// A grasp as its text file states it, and the five steps from rest to the closed hand.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "graspdb/angles.h"
#include "graspdb/solid.h"
#include "graspdb/transform.h"

namespace graspdb {

// Where the fingers are and how the object lies in the hand.
struct GraspPose {
  JointAngles angles = JointAngles::Zero();
  RigidTransform hand_from_object;
};

enum class Opposition { kPalm, kPad, kSide };

// One file of grasps/*.toml; docs/grasps.md describes the format.
struct Grasp {
  int id = 0;  // 1..33 are Feix's, a user's own start at 100
  std::string name;
  std::string type;  // power, intermediate, precision
  Opposition opposition = Opposition::kPalm;
  bool thumb_abducted = true;
  std::vector<int> required_digits;  // that must touch: 1 thumb .. 5 little, 0 palm
  std::vector<int> free_digits;      // that must not touch
  std::shared_ptr<const Solid> object;
  std::string object_name;
  GraspPose start;  // where the closing begins
  std::filesystem::path file;
};

constexpr int kStepCount = 5;

// All grasps of a folder by id. Throws Error for a broken file and for two with one id.
std::vector<Grasp> load_grasps(const std::filesystem::path& directory);
Grasp load_grasp(const std::filesystem::path& file);
JointAngles load_rest_pose(const std::filesystem::path& directory);

// Step 1..steps: step / steps of the way from rest to closed. The object keeps its place in the
// world while the hand closes and translates, so that `hand_from_object` differs from step to step.
GraspPose pose_at_step(const Grasp& grasp, const JointAngles& rest, const GraspPose& closed,
                       int step, int steps = kStepCount);

}  // namespace graspdb
