// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "generator/small_build.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "graspdb/hand/skeleton.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {

// 96 rows: two grasps, held and free, two steps, twelve views. Made once a program.
inline const Database& small_database() {
  static const TemporaryDirectory directory;
  static const Database database = [] {
    build_database(small_config(), {.out = directory / "small.graspdb"});
    return Database::open(directory / "small.graspdb");
  }();
  return database;
}

// The bones whose skin may be seen where a keypoint is: those of its own digit; around the wrist
// and where the thumb begins also the palm, and of a knuckle the palm where a hand's skin lies so.
inline std::set<int> bones_around(int keypoint) {
  if (keypoint == 0) return {kForearm, kPalm, kThumbMetacarpal};
  if (keypoint <= 4) {
    std::set<int> bones = {kThumbMetacarpal, kThumbProximal, kThumbDistal};
    if (keypoint == 1) bones.insert({kPalm, kForearm});
    return bones;
  }
  std::set<int> bones;
  for (int bone = kMetacarpal; bone <= kDistal; ++bone) {
    bones.insert(finger_bone((keypoint - 5) / 4, static_cast<FingerBone>(bone)));
  }
  return bones;
}

}  // namespace graspdb::testing
