// SPDX-License-Identifier: MIT
// Written by scripts/tune.py.
#include "graspdb/error.h"
#include "graspdb/tracker.h"

namespace graspdb {

TrackerOptions tuned_options(TemporalModel temporal) {
  switch (temporal) {
    case TemporalModel::kNone:
      return {.temporal = temporal, .neighbours = 200, .sigma_hog = 0.7, .sigma_stretch = 0.2};
    case TemporalModel::kGaussian:
      return {.temporal = temporal,
              .neighbours = 50,
              .sigma_hog = 1.0,
              .sigma_stretch = 0.3,
              .sigma_pose = 0.35};
    case TemporalModel::kKde:
      return {.temporal = temporal,
              .neighbours = 200,
              .kept = 50,
              .sigma_hog = 1.0,
              .sigma_stretch = 0.15,
              .bandwidth = 0.35};
    case TemporalModel::kSuccessors:
      return {.temporal = temporal,
              .neighbours = 10,
              .kept = 100,
              .sigma_hog = 0.7,
              .sigma_stretch = 0.1,
              .bandwidth = 0.35};
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
