// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "frame_source.h"
#include "graspdb/database.h"
#include "graspdb/tracker.h"

namespace graspdb::cli {

// One line of `track --json`, without a line end. `segment_ms` and `total_ms` are the caller's
// times.
std::string to_json_line(const InputFrame& frame, const Estimate& estimate,
                         const Database& database, double segment_ms, double total_ms);

}  // namespace graspdb::cli
