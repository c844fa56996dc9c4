// SPDX-License-Identifier: MIT
// The hands of training pictures, and how they close on objects.
#pragma once

#include <memory>
#include <vector>

#include "graspdb/core/random.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"
#include "graspdb/samples/samples.h"

namespace graspdb {

// A hand of a file, with every grasp closed on it.
struct BaseHand {
  Hand hand;
  std::vector<Grasp> grasps;  // in this hand's size
  std::vector<GraspPose> closed;
};

// One that is shown: a base hand, or one that is made. A made hand holds things as the base hand
// nearest to it in length does, with all lengths scaled by `scale`: its fingers may miss or enter
// an object by a few millimetres.
struct SampleHand {
  Hand hand;
  const BaseHand* base = nullptr;
  double scale = 1;
};

struct HandLibrary {
  std::vector<BaseHand> bases;
  JointAngles rest;
  std::vector<SampleAsset> assets;  // of hands and grasps
};
HandLibrary load_hand_library(const SampleConfig& config, int threads);

// Takes a second when it makes one.
SampleHand draw_hand(const HandLibrary& library, const SampleConfig& config, RandomStream random);

}  // namespace graspdb
