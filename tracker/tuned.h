// SPDX-License-Identifier: MIT
// What scripts/tune.py has chosen.
#pragma once

#include "graspdb/tracker/tracker.h"

namespace graspdb {

TrackerOptions tuned_for_hogs(TemporalModel temporal);
TrackerOptions tuned_for_codes(TemporalModel temporal);

}  // namespace graspdb
