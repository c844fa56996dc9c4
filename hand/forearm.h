// SPDX-License-Identifier: MIT
// A forearm for rigs that end at the wrist.
#pragma once

#include <optional>
#include <string>

#include "rig_map.h"
#include "rig_skin.h"

namespace graspdb {

// Lengthens the hand's end, a cap or an open loop, by `length` metres along `elbow` (a unit vector
// in the palm's frame) and closes it. The new skin moves with that of the end. Returns what is
// wrong with an end that is neither, and then changes nothing.
std::optional<std::string> extend_forearm(double length, const Eigen::Vector3d& elbow,
                                          RigSkin& skin);

// Gives the skin beyond the wrist to the forearm, whatever bone of the hand it moved with.
void split_forearm(const ForearmSplit& split, const Eigen::Vector3d& elbow, RigSkin& skin);

}  // namespace graspdb
