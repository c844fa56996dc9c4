// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "graspdb/core/remarks.h"
#include "graspdb/database/database.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// Which frame a line is about.
struct FrameName {
  int number = 0;    // from 0
  double time = 0;   // seconds
  std::string file;  // of a picture; empty for a video's and a camera's
  std::optional<Intrinsics> camera;
  std::string camera_from;  // "sequence", "calibration", "--focal", "EXIF" or "guess"
};

// A sentence; empty for an answer.
std::string why_no_answer(const Estimate& estimate);

// One line of `track --json`, without a line end; docs/tracking.md names every key.
std::string estimate_json(const FrameName& frame, const Estimate& estimate,
                          const Database& database, const Remarks& remarks = {});

}  // namespace graspdb
