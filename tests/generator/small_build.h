// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "graspdb/generator/build_config.h"

namespace graspdb::testing {

// Two grasps, held and free, two steps, twelve small views: 96 rows in 4 shards.
inline BuildConfig small_config() {
  const std::filesystem::path source = GRASPDB_SOURCE_DIR;
  BuildConfig config;
  config.hands = {source / "assets/hands/male.glb"};
  config.grasps = source / "grasps";
  config.only = {3, 9};
  config.objects = Objects::kBoth;
  config.steps = 2;
  config.views = 12;
  config.resolution = 48;
  return config;
}

}  // namespace graspdb::testing
