// SPDX-License-Identifier: MIT
// A hand with or without what it holds, ready to be looked at.
#pragma once

#include <Eigen/Core>

#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"
#include "graspdb/renderer/renderer.h"

namespace graspdb {

// The hand with its forearm ending `length` metres beyond the wrist joint: skin further away is
// moved onto the end plane, so that the surface stays closed. A shorter forearm stays as it is.
Hand with_visible_forearm(Hand hand, double length);

// Immutable; may be rendered from many threads.
struct PosedScene {
  Scene scene;
  std::vector<Eigen::Vector3f> hand_vertices;  // hand frame, metres
  Eigen::Vector3d center;                      // palm_centre, what cameras look at
};

// Enough rays for smooth creases at a vertex spacing of 2-3 mm.
constexpr int kOpennessRays = 24;

// `object` may be null: then the hand is free. Creases are darkened (ambient_openness).
PosedScene pose_scene(const Hand& hand, const GraspPose& pose, const Solid* object,
                      int openness_rays = kOpennessRays);

}  // namespace graspdb
