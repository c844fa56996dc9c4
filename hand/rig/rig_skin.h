// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/hand.h"
#include "rig_file.h"
#include "rig_map.h"

namespace graspdb {

// The skin at rest in the hand frame, and how much each of our bones moves of every vertex.
struct RigSkin {
  Mesh mesh;
  std::vector<PerBone<double>> weights;
};

// Throws Error, naming map, file and bone, for skin on a bone that the map does not name, and for
// skin further from the wrist than a forearm reaches.
RigSkin skin_in_hand(const RigMap& map, const RigFile& file, const RigidTransform& hand_from_file);

// What linear blending takes: the four largest, which sum to 1.
std::vector<SkinWeights> four_largest(const std::vector<PerBone<double>>& weights);

}  // namespace graspdb
