// SPDX-License-Identifier: MIT
// A forearm for rigs that end at the wrist.
#pragma once

#include <optional>
#include <string>

#include "rig_map.h"
#include "rig_skin.h"

namespace graspdb {

// Opens the hand's end towards the elbow (a unit vector in the hand frame): takes its cap off,
// unless it is open already. Returns what is wrong when the open edges are then not one loop, or
// one that is not the forearm's rim: round its axis, beyond the wrist, on skin that palm and
// forearm move, with no skin nearer to the elbow. In that case it changes nothing.
std::optional<std::string> open_end(const Eigen::Vector3d& elbow, RigSkin& skin);

// Lengthens an open end by `length` metres and closes it. The new skin moves with that of the end.
void extend_forearm(double length, const Eigen::Vector3d& elbow, RigSkin& skin);

// Gives the skin beyond the wrist to the forearm, whatever bone of the hand it moved with.
void split_forearm(const ForearmSplit& split, const Eigen::Vector3d& elbow, RigSkin& skin);

}  // namespace graspdb
