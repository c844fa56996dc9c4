// SPDX-License-Identifier: MIT
// Tables on stdout.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graspdb/evaluation_set.h"
#include "graspdb/metrics.h"
#include "graspdb/tracker.h"

namespace graspdb::cli {

struct TrackStatistics {
  std::size_t frames = 0, valid = 0;
  std::vector<double> segment, describe, search, temporal, total;  // ms a frame

  void add(const Estimate& estimate, double segment_ms, double total_ms);
};
void print(const TrackStatistics& statistics);

// One line an answer, then oracle, random row and constant guess.
void print_error_table(const std::vector<std::pair<std::string, Summary>>& answers,
                       const Baselines& baselines);

void print(const SequenceEvaluation& sequence);
void print(const SetEvaluation& set, FrameKind kind, std::size_t sequences);

}  // namespace graspdb::cli
