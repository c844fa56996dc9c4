// SPDX-License-Identifier: MIT
// Written by scripts/tune.py.
#include "graspdb/core/error.h"
#include "tuned.h"

namespace graspdb {

TrackerOptions tuned_for_hogs(TemporalModel temporal) {
  switch (temporal) {
    case TemporalModel::kNone:
      return {.temporal = temporal,
              .neighbors = 200,
              .roll_deg = 0,
              .kept = 20,
              .sigma_hog = 0.7,
              .sigma_stretch = 0.2,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.35,
              .merge_deg = 0,
              .max_distance = 5.0};
    case TemporalModel::kGaussian:
      return {.temporal = temporal,
              .neighbors = 50,
              .roll_deg = 0,
              .kept = 20,
              .sigma_hog = 1.0,
              .sigma_stretch = 0.3,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.35,
              .merge_deg = 0,
              .max_distance = 5.0};
    case TemporalModel::kKde:
      return {.temporal = temporal,
              .neighbors = 200,
              .roll_deg = 0,
              .kept = 50,
              .sigma_hog = 1.0,
              .sigma_stretch = 0.15,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.35,
              .merge_deg = 0,
              .max_distance = 5.0};
    case TemporalModel::kSuccessors:
      return {.temporal = temporal,
              .neighbors = 10,
              .roll_deg = 0,
              .kept = 100,
              .sigma_hog = 0.7,
              .sigma_stretch = 0.1,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.35,
              .merge_deg = 0,
              .max_distance = 5.0};
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
