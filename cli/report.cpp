// SPDX-License-Identifier: MIT
#include "report.h"

#include <fmt/format.h>

namespace graspdb::cli {
namespace {

void print_stage(const char* name, const std::vector<double>& ms) {
  const Spread s = spread(ms);
  fmt::print("  {:9} median {:7.3f} ms   p90 {:7.3f} ms\n", name, s.median, s.p90);
}

void print_line(const std::string& name, const Summary& s) {
  fmt::print("{:22} {:10.2f} {:8.1f} {:8.1f} {:8.1f} {:7.1f} {:8.1f} {:8.1f} {:6.0f} %\n", name,
             s.pose_error, s.rotation_deg.mean, s.rotation_deg.median, s.rotation_deg.p90,
             s.joint_deg, s.mpjpe_mm, s.pa_mpjpe_mm, 100 * s.flips);
}

}  // namespace

void TrackStatistics::add(const Estimate& estimate, double segment_ms, double total_ms) {
  ++frames;
  valid += estimate.valid ? 1 : 0;
  segment.push_back(segment_ms);
  describe.push_back(estimate.ms.describe);
  search.push_back(estimate.ms.search);
  temporal.push_back(estimate.ms.temporal);
  total.push_back(total_ms);
}

void print(const TrackStatistics& statistics) {
  fmt::print("{} frames, {} with a hand; time a frame:\n", statistics.frames, statistics.valid);
  print_stage("segment", statistics.segment);
  print_stage("describe", statistics.describe);
  print_stage("search", statistics.search);
  print_stage("temporal", statistics.temporal);
  print_stage("total", statistics.total);
}

void print_error_table(const std::vector<std::pair<std::string, Summary>>& answers,
                       const Baselines& baselines) {
  fmt::print("{:22} {:>10} {:>8} {:>8} {:>8} {:>7} {:>8} {:>8} {:>8}\n", "", "pose error",
             "rot mean", "median", "p90 deg", "jnt deg", "mpjpe mm", "pa mm", "flips");
  for (const auto& [name, summary] : answers) print_line(name, summary);
  print_line("oracle", baselines.oracle);
  print_line("random row", baselines.random);
  print_line("best constant", baselines.constant);
  fmt::print(
      "fingers to the nearest pose of the database: median {:.1f} deg, beyond 5 deg in {:.0f} % of "
      "frames\n",
      baselines.nearest_pose_deg.median, 100 * baselines.share_beyond_5_deg);
}

}  // namespace graspdb::cli
