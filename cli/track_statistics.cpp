// SPDX-License-Identifier: MIT
#include "track_statistics.h"

#include <fmt/format.h>

#include "graspdb/evaluation/metrics.h"

namespace graspdb::cli {
namespace {

void print_stage(std::FILE* to, const char* name, const std::vector<double>& ms) {
  const Spread s = spread(ms);
  fmt::print(to, "  {:9} median {:7.3f} ms   p90 {:7.3f} ms\n", name, s.median, s.p90);
}

}  // namespace

void TrackStatistics::add(const Estimate& estimate) {
  ++frames;
  seen += estimate.box.width > 0 ? 1 : 0;
  valid += estimate.valid ? 1 : 0;
  segment.push_back(estimate.ms.segment);
  describe.push_back(estimate.ms.describe);
  search.push_back(estimate.ms.search);
  temporal.push_back(estimate.ms.temporal);
  total.push_back(estimate.ms.total);
}

void print(const TrackStatistics& statistics, std::FILE* to) {
  fmt::print(to, "{} frames, {} with a hand; time per frame:\n", statistics.frames,
             statistics.valid);
  print_stage(to, "segment", statistics.segment);
  print_stage(to, "describe", statistics.describe);
  print_stage(to, "search", statistics.search);
  print_stage(to, "temporal", statistics.temporal);
  print_stage(to, "total", statistics.total);
}

}  // namespace graspdb::cli
