// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "graspdb/sequences/sequence.h"

namespace graspdb::testing {

// The project's own tripod on the male hand, whose closed pose it keeps: four small frames.
inline SequenceSpec tripod_sequence() {
  const std::filesystem::path source = GRASPDB_SOURCE_DIR;
  SequenceSpec spec;
  spec.name = "tripod";
  spec.camera = {.width = 320, .height = 240, .fx = 300, .fy = 300, .cx = 159.5, .cy = 119.5};
  spec.visible_forearm = 0.05;
  spec.look.skin_bgr = spec.look.object_bgr = {100, 150, 200};
  spec.hand.file = source / "assets/hands/male.glb";
  spec.grasp = load_grasp(source / "grasps/14_tripod.toml");
  spec.rest = load_rest_pose(source / "grasps");
  spec.keyframes = {{.time = 0, .closure = 0, .view = {kPi, 0, 0}, .palm = {0, 0, 0.5}},
                    {.time = 0.3, .closure = 1, .view = {2, 0.3, 0}, .palm = {0.02, 0.01, 0.6}}};
  return spec;
}

}  // namespace graspdb::testing
