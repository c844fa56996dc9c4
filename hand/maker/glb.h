// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "graspdb/hand/hand.h"

namespace graspdb {

// A binary glTF 2.0 file: one skinned mesh in metres in the hand frame, a joint a bone by its
// bone_name(), and one for each tip by its keypoint_name(). The forearm's joint lies near the
// elbow, so that it says which way the forearm runs. The same hand gives the same bytes.
std::string hand_to_glb(const Hand& hand);

}  // namespace graspdb
