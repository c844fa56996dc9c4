// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "graspdb/hand/hand.h"

namespace graspdb {

// The names of the five joints at the tips of thumb, index, middle, ring and little.
extern const std::array<std::string, 5> kTipNames;

// A binary glTF 2.0 file: one skinned mesh in metres in the hand frame, a joint a bone by its
// bone_name(), and a joint a tip. The forearm's joint lies near the elbow, so
// that it says which way the forearm runs.
// The same hand gives the same bytes.
std::string hand_to_glb(const Hand& hand);

}  // namespace graspdb
