// SPDX-License-Identifier: MIT
// What the hands of training pictures do.
#pragma once

#include <memory>

#include "graspdb/core/random.h"
#include "sample_hands.h"

namespace graspdb {

struct SamplePose {
  GraspPose pose;
  std::shared_ptr<const Solid> object;  // null: the hand is free
  int grasp = 0;                        // id; 0 of a free hand
  double visible_forearm = 0;           // metres
};

SamplePose draw_pose(const HandLibrary& library, const SampleHand& hand, const SampleConfig& config,
                     RandomStream& random);

}  // namespace graspdb
