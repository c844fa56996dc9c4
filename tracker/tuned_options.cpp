// SPDX-License-Identifier: MIT
// Written by scripts/tune.py.
#include "graspdb/error.h"
#include "graspdb/tracker.h"

namespace graspdb {

TrackerOptions tuned_options(TemporalModel temporal) {
  switch (temporal) {
    case TemporalModel::kNone:
      return {.temporal = temporal, .neighbours = 400, .sigma_hog = 1.0, .sigma_stretch = 0.2};
    case TemporalModel::kGaussian:
      return {.temporal = temporal,
              .neighbours = 50,
              .sigma_hog = 2.0,
              .sigma_stretch = 0.15,
              .sigma_pose = 0.35};
    case TemporalModel::kKde:
      return {.temporal = temporal,
              .neighbours = 50,
              .kept = 20,
              .sigma_hog = 2.0,
              .sigma_stretch = 0.15,
              .bandwidth = 0.25};
    case TemporalModel::kSuccessors:
      return {.temporal = temporal,
              .neighbours = 20,
              .kept = 20,
              .sigma_hog = 1.0,
              .sigma_stretch = 0.15,
              .bandwidth = 0.35};
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
