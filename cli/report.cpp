// SPDX-License-Identifier: MIT
#include "report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace graspdb::cli {
namespace {

struct Column {
  int metric;
  const char* title;
  int decimals = 1;
  double factor = 1;  // 100 for shares in percent
};
constexpr std::array<Column, 13> kColumns = {{{kPoseError, "pose err", 2},
                                              {kRotationDeg, "rot deg"},
                                              {kFlips, "flips %", 0, 100},
                                              {kJointDeg, "jnt deg"},
                                              {kThumbDeg, "thumb deg"},
                                              {kMpjpeMm, "mpjpe mm"},
                                              {kSnMpjpeMm, "sn mm"},
                                              {kPaMpjpeMm, "pa mm"},
                                              {kError2dPalms, "2d palms", 2},
                                              {kGraspTop1, "top1 %", 0, 100},
                                              {kGraspTop5, "top5 %", 0, 100},
                                              {kGrasp17Top1, "17: top1", 0, 100},
                                              {kJitterMm, "jitter mm"}}};

// Intervals take room; eval.json has those of all metrics.
constexpr std::array<Column, 6> kSetColumns = {{{kPoseError, "pose error", 2},
                                                {kRotationDeg, "rotation deg"},
                                                {kFlips, "flips %", 0, 100},
                                                {kJointDeg, "joint deg"},
                                                {kMpjpeMm, "mpjpe mm"},
                                                {kGraspTop1, "top1 %", 0, 100}}};

void print_stage(const char* name, const std::vector<double>& ms) {
  const Spread s = spread(ms);
  fmt::print("  {:9} median {:7.3f} ms   p90 {:7.3f} ms\n", name, s.median, s.p90);
}

std::string number(double value, int decimals) {
  if (std::isnan(value)) return "-";
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string number(double value, const Column& column) {
  return number(value * column.factor, column.decimals);
}

void print_line(const std::string& name, const Summary& summary) {
  fmt::print("{:22}", name);
  for (const Column& column : kColumns)
    fmt::print(" {:>9}", number(summary.mean[static_cast<std::size_t>(column.metric)], column));
  fmt::print("\n");
}

std::string run_name(TemporalModel model, double alpha) {
  return fmt::format("{} alpha {} %", temporal_name(model), alpha);
}

std::string interval_text(const Interval& interval, const Column& column) {
  if (interval.sequences < 2) return number(interval.mean, column);
  return fmt::format("{} [{}, {}]", number(interval.mean, column), number(interval.low, column),
                     number(interval.high, column));
}

void print_line(const std::string& name, const MetricIntervals& metrics) {
  fmt::print("{:26}", name);
  for (const Column& column : kSetColumns) {
    const auto metric = static_cast<std::size_t>(column.metric);
    fmt::print(" {:>20}", interval_text(metrics[metric], column));
  }
  fmt::print("\n");
}

void print_titles(const std::string& name) {
  fmt::print("{:26}", name);
  for (const Column& column : kSetColumns) fmt::print(" {:>20}", column.title);
  fmt::print("\n");
}

std::string difference_name(const SetDifference& d) {
  if (d.alpha == d.minus_alpha) {
    return fmt::format("{} - {} at {} %", temporal_name(d.temporal),
                       temporal_name(d.minus_temporal), d.alpha);
  }
  return fmt::format("{}: {} % - {} %", temporal_name(d.temporal), d.alpha, d.minus_alpha);
}

void print_gap(const std::string& name, const Gap& gap, int decimals) {
  fmt::print("{:30}", name);
  for (const double part : {gap.total(), gap.retrieval, gap.choice, gap.placement, gap.unanswered})
    fmt::print(" {:>10}", number(part, decimals));
  fmt::print("  |");
  for (const double part : {gap.view, gap.pose}) fmt::print(" {:>8}", number(part, decimals));
  fmt::print("\n");
}

void print_gaps(const std::vector<SetRun>& runs) {
  fmt::print("\n{:30} {:>10} {:>10} {:>10} {:>10} {:>10}  | {:>8} {:>8}\n", "gap to the oracle",
             "total", "retrieval", "choice", "placement", "unanswered", "view", "pose");
  for (const SetRun& run : runs) {
    const std::string name = run_name(run.temporal, run.alpha);
    print_gap(name, run.pose_error_gap, 2);
    print_gap(name + ", mpjpe", run.mpjpe_gap, 1);
  }
}

void print_calibration(const std::vector<SetRun>& runs) {
  fmt::print("\n{:30}", fmt::format("right to {} deg by confidence", kRecoveredDeg));
  for (std::size_t bin = 1; bin <= kCalibrationBins; ++bin)
    fmt::print(" {:>5}", fmt::format("-{:.1f}", static_cast<double>(bin) / kCalibrationBins));
  fmt::print("   expected calibration error\n");
  for (const SetRun& run : runs) {
    fmt::print("{:30}", run_name(run.temporal, run.alpha));
    for (const CalibrationBin& bin : run.calibration.bins)
      fmt::print(" {:>5}", bin.frames > 0 ? fmt::format("{:.2f}", bin.right) : "-");
    fmt::print("   {:.3f}\n", run.calibration.expected_error);
  }
}

void print_recovery(const SetRecovery& recovery) {
  const Column frames{kMetricCount, "", 1};
  fmt::print(
      "after {} black frames {:8} recovers in {} of {} sequences; wrong frames until then {}\n",
      kBlackFrames, temporal_name(recovery.temporal), recovery.recovered, recovery.sequences,
      interval_text(recovery.frames, frames));
}

void print_far_grasps(int beyond, int frames) {
  fmt::print(
      "fingers are 5 degrees or more from the nearest pose of the database in {} of {} "
      "grasping frames\n",
      beyond, frames);
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
  fmt::print("{:22}", "");
  for (const Column& column : kColumns) fmt::print(" {:>9}", column.title);
  fmt::print("\n");
  for (const auto& [name, summary] : answers) print_line(name, summary);
  print_line("oracle", baselines.oracle_mean);
  print_line("random row", baselines.random);
  print_line("best constant", baselines.constant);
}

void print(const SequenceEvaluation& sequence) {
  const EvalRun& first = sequence.runs.front();
  fmt::print("\n{}, {} frames: smallest hand box {:.0f} px, {:.0f} % of frames valid at alpha {}\n",
             sequence.name, kind_name(sequence.kind), first.smallest_box_px, 100 * first.valid,
             first.alpha);
  if (sequence.kind == FrameKind::kPhotoreal) {
    fmt::print("found hand against true hand, mean intersection over union: {}\n",
               number(sequence.segmentation_iou, 3));
  }
  std::vector<std::pair<std::string, Summary>> lines;
  for (const EvalRun& run : sequence.runs)
    lines.emplace_back(run_name(run.temporal, run.alpha), run.errors);
  print_error_table(lines, sequence.baselines);
  print_far_grasps(sequence.beyond_5_deg, sequence.grasping_frames);
}

void print(const SetEvaluation& set, FrameKind kind, std::size_t sequences) {
  fmt::print("\nMeans over {} {} sequences with 95 % intervals\n", sequences, kind_name(kind));
  print_titles("");
  for (const SetRun& run : set.runs) print_line(run_name(run.temporal, run.alpha), run.means);
  print_line("oracle", set.oracle);
  print_line("random row", set.random);
  print_line("best constant", set.constant);
  fmt::print("\n");
  print_titles("paired differences");
  for (const SetDifference& difference : set.differences)
    print_line(difference_name(difference), difference.differences);
  print_gaps(set.runs);
  print_calibration(set.runs);
  fmt::print("\n");
  for (const SetRecovery& recovery : set.recoveries) print_recovery(recovery);
  print_far_grasps(set.beyond_5_deg, set.grasping_frames);
}

}  // namespace graspdb::cli
