// SPDX-License-Identifier: MIT
// One picture of a hand as a camera and a finder might show it.
#pragma once

#include <optional>

#include "graspdb/core/random.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/samples/samples.h"

namespace graspdb {

// A posed hand and where its forearm points to, in the hand frame.
struct SampleScene {
  PosedScene posed;
  Eigen::Vector3d towards_elbow;  // unit
};

// Crop and rotation; none when too little of the hand is seen.
std::optional<Sample> draw_picture(const SampleScene& scene, const SampleConfig& config,
                                   RandomStream& random);

}  // namespace graspdb
