// SPDX-License-Identifier: MIT
// A grasp as its text file states it, and the five steps from rest to the closed hand.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/transform.h"
#include "graspdb/geometry/solid.h"
#include "graspdb/hand/angles.h"
#include "graspdb/hand/digits.h"

namespace graspdb {

// Where the fingers are and how the object lies in the hand.
struct GraspPose {
  JointAngles angles = JointAngles::Zero();
  RigidTransform hand_from_object;
};

enum class Opposition { kPalm, kPad, kSide };

// In grasps a `digit` may be the palm, 0; the thumb is 1 (digits.h).

// A stretch of one side of a bone (of the palm: of all that is not a digit), in shares of the
// bone's length from its own joint (0) to the next one or the tip (1).
enum class SkinSide { kPalmar, kRadial, kUlnar };
struct ContactArea {
  std::string name;  // as in the file, e.g. "pulp"
  int digit = 0;
  int bone = 0;
  SkinSide side = SkinSide::kPalmar;
  double from = 0;
  double to = 1;
};

// Where the straight way from rest to closed would lead through the object, the hand goes by way of
// this.
struct Waypoint {
  double progress = 0;                      // of the way, above 0 and below 1
  JointAngles angles;                       // NaN for what goes straight
  std::optional<Eigen::Vector3d> approach;  // as in Grasp, at this place
};

constexpr int kLargestGrasp = 65535;  // an id

// One file of grasps/*.toml; docs/grasps.md describes the format.
struct Grasp {
  int id = 0;  // 1..33 are Feix's, a user's own start at 100
  std::string name;
  std::string type;  // power, intermediate, precision
  Opposition opposition = Opposition::kPalm;
  std::vector<std::vector<int>> virtual_fingers;  // digits that act as one, the palm is 0
  bool thumb_abducted = true;
  std::vector<ContactArea> contacts;  // what the closing brings to the object
  std::vector<int> required_digits;   // that must touch: those of `contacts`, sorted
  std::vector<int> free_digits;       // that must not touch
  std::shared_ptr<const Solid> object;
  std::string object_name;
  std::filesystem::path object_file;          // of a mesh; empty for a primitive
  std::string object_origin, object_license;  // of a mesh, as the file states them; may be empty
  bool object_scales = false;  // with the hand: `object` is that of kReferenceHandLength
  // Where the closing begins, on a hand of kReferenceHandLength. The object's place is seen from
  // the hand frame or, with `from_contacts`, from the middle between the thumb's contact areas and
  // those of all others, as they are in `start.angles`.
  GraspPose start;
  bool from_contacts = false;
  // How much further from its place in the closed hand the object is when the hand is at rest,
  // hand frame, metres.
  Eigen::Vector3d approach = Eigen::Vector3d::Zero();
  std::vector<Waypoint> waypoints;  // in the order of their progress
  std::filesystem::path file;
};

// Places in the hand are stated for a hand of this length, metres, and scale with another's.
constexpr double kReferenceHandLength = 0.193;

constexpr int kStepCount = 5;

// The project's own grasps: grasps/ in the data directory.
std::filesystem::path grasp_directory();

// All grasps of a folder (its *.toml except rest.toml) by id. Throws Error for a broken file and
// for two with one id.
std::vector<Grasp> load_grasps(const std::filesystem::path& directory);
Grasp load_grasp(const std::filesystem::path& file);
// A folder's rest.toml or, where it has none, the project's.
JointAngles load_rest_pose(const std::filesystem::path& directory);

// Step 0..steps: step / steps of the way from rest to closed, straight from one waypoint to the
// next. The object keeps its place in the world while the hand closes and translates, so that
// `hand_from_object` differs from step to step.
GraspPose pose_at_step(const Grasp& grasp, const JointAngles& rest, const GraspPose& closed,
                       int step, int steps = kStepCount);

}  // namespace graspdb
