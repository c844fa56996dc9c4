// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "graspdb/core/remarks.h"
#include "graspdb/database/database.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// One line of `track --json`, without a line end; docs/tracking.md names every key. `frame` counts
// from 0.
std::string estimate_json(int frame, double time_s, const Estimate& estimate,
                          const Database& database, const Remarks& remarks = {});

}  // namespace graspdb
