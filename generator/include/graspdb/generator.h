// SPDX-License-Identifier: MIT
// Makes a database: every hand x variant x grasp x step x view is one row, and a row is a pure
// function of the configuration and its number:
//   row = (((hand * variants + variant) * grasps + grasp ordinal) * steps + step - 1) * views +
//   view.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "graspdb/database.h"
#include "graspdb/hog.h"
#include "graspdb/progress.h"
#include "graspdb/renderer.h"

namespace graspdb {

enum class Objects { kHeld, kFree, kBoth };

struct BuildConfig {
  std::vector<std::filesystem::path> hands;  // .glb files with their rig maps beside them
  std::filesystem::path grasps;              // the folder of grasp files
  std::vector<int> only;                     // grasp ids; empty = all
  Objects objects = Objects::kHeld;
  int steps = 5;                   // 1..20
  int views = 648;                 // 1..100000
  int resolution = 128;            // pixels a side, 16..1024
  double distance = 0.7;           // metres from camera to palm centre
  double visible_forearm = 0.015;  // metres beyond the wrist joint
  Light light;
  HogOptions hog{.mode = HogMode::kEdges};
  int threads = 0;  // 0 = all processors; does not change a byte
};

struct BuildReport {
  std::size_t rows = 0;
  double seconds = 0;
  std::uintmax_t bytes = 0;
  std::string content_hash;
};

// Builds all rows and writes them to `out`, aside and renamed. Throws Error for bad input; nothing
// is left under `out` then.
BuildReport build_database(const BuildConfig& config, const std::filesystem::path& out,
                           const Progress& progress = {});

}  // namespace graspdb
