// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "graspdb/hand/skeleton.h"

namespace graspdb {

// Where a digit ends: at a joint of the file, at a point (the file's coordinates at rest), or
// beyond its last joint, through the middle of its last bone's skin: so many metres or, when the
// map does not say, as far as the surface.
using TipPlace = std::variant<std::monostate, std::string, Eigen::Vector3d, double>;

// Which skin beyond the wrist is the forearm's: half of it at `at`, all of it `width / 2` further
// towards the elbow. Metres from the wrist.
struct ForearmSplit {
  double at;
  double width;
};

// What a rigged file's bones are to graspdb: the text file beside it.
struct RigMap {
  std::string file;             // of the map itself, for messages
  std::string origin, license;  // empty: not stated
  bool is_left = false;
  double meters_per_unit = 1;
  Eigen::Vector3d thumb_nail;  // unit vector, the file's coordinates in its rest pose
  // The first of a bone's names gives the joint; the skin of all of them moves with it. Those of
  // the fingers' metacarpals and of the forearm may be empty.
  PerBone<std::vector<std::string>> bones;
  std::array<TipPlace, 5> tips;
  // Which of our bones the skin of each bone of the file moves with, tips included.
  std::map<std::string, int, std::less<>> bone_of_name;
  std::optional<ForearmSplit> forearm_split;  // there exactly when no bone is the forearm
  double forearm_extension = 0;               // metres
  // How far a bone's joint is moved towards the bone's far end, metres, and how far round its
  // length a finger lies at rest, its back to the thumb's side, radians.
  PerBone<double> moved_along{};
  std::array<double, kFingerCount> finger_rolls{};
  std::optional<double> longest_edge;  // metres; longer ones are halved
  bool bind_half_bent = false;         // see bound_half_bent
};

RigMap load_rig_map(const std::filesystem::path& path);

std::string bone_key(int bone);  // e.g. "bones.index_proximal", for messages
std::string tip_key(int digit);  // e.g. "tips.thumb"

}  // namespace graspdb
