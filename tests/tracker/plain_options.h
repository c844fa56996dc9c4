// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/tracker/tracker.h"

namespace graspdb::testing {

// What a test wants of a tracker's options; the others are plain round numbers.
struct PlainOptions {
  TemporalModel temporal = TemporalModel::kKde;
  int neighbors = 20, kept = 20;
  double sigma_hog = 1, sigma_stretch = 0.15, merge_deg = 0, max_distance = 5, roll_deg = 0;
  double sigma_arm_deg = 1000, reach = 0;

  operator TrackerOptions() const {
    return {.temporal = temporal,
            .neighbors = neighbors,
            .roll_deg = roll_deg,
            .kept = kept,
            .sigma_hog = sigma_hog,
            .sigma_stretch = sigma_stretch,
            .sigma_arm_deg = sigma_arm_deg,
            .sigma_pose = 0.5,
            .bandwidth = 0.5,
            .merge_deg = merge_deg,
            .reach = reach,
            .max_distance = max_distance};
  }
};

}  // namespace graspdb::testing
