// SPDX-License-Identifier: MIT
// Written by scripts/tune.py.
#include "graspdb/core/error.h"
#include "tuned.h"

namespace graspdb {

TrackerOptions tuned_for_codes(TemporalModel temporal) {
  switch (temporal) {
    case TemporalModel::kNone:
      return {.temporal = temporal,
              .neighbors = 130,
              .roll_deg = 40,
              .kept = 20,
              .sigma_hog = 0.2,
              .sigma_stretch = 0.5,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.35,
              .merge_deg = 60,
              .max_distance = 0.65};
    case TemporalModel::kGaussian:
      return {.temporal = temporal,
              .neighbors = 130,
              .roll_deg = 40,
              .kept = 20,
              .sigma_hog = 0.24,
              .sigma_stretch = 0.5,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.7,
              .bandwidth = 0.35,
              .merge_deg = 60,
              .max_distance = 0.65};
    case TemporalModel::kKde:
      return {.temporal = temporal,
              .neighbors = 130,
              .roll_deg = 40,
              .kept = 20,
              .sigma_hog = 0.24,
              .sigma_stretch = 0.5,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 0.7,
              .merge_deg = 60,
              .max_distance = 0.65};
    case TemporalModel::kSuccessors:
      return {.temporal = temporal,
              .neighbors = 130,
              .roll_deg = 40,
              .kept = 20,
              .sigma_hog = 0.18,
              .sigma_stretch = 0.5,
              .sigma_arm_deg = 30,
              .sigma_pose = 0.35,
              .bandwidth = 1.0,
              .merge_deg = 60,
              .max_distance = 0.65};
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
