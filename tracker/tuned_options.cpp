// SPDX-License-Identifier: MIT
#include "graspdb/error.h"
#include "graspdb/tracker.h"

namespace graspdb {

TrackerOptions tuned_options(TemporalModel temporal) {
  TrackerOptions options{.temporal = temporal};
  switch (temporal) {
    case TemporalModel::kNone:
    case TemporalModel::kGaussian:
    case TemporalModel::kKde:
      return options;
    case TemporalModel::kSuccessors:
      options.neighbours = 50;
      options.sigma_stretch = 0.2;
      options.bandwidth = 0.35;
      return options;
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
