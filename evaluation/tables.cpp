// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/tables.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "graspdb/core/append.h"

namespace graspdb {
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
                                              {kUnsteadinessMm, "jitter mm"}}};

// Intervals take room; eval.json has those of all metrics.
constexpr std::array<Column, 6> kSetColumns = {{{kPoseError, "pose error", 2},
                                                {kRotationDeg, "rotation deg"},
                                                {kFlips, "flips %", 0, 100},
                                                {kJointDeg, "joint deg"},
                                                {kMpjpeMm, "mpjpe mm"},
                                                {kGraspTop1, "top1 %", 0, 100}}};

std::string number(double value, int decimals) {
  if (std::isnan(value)) return "-";
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string number(double value, const Column& column) {
  return number(value * column.factor, column.decimals);
}

void add_line(std::string& out, const std::string& name, const Summary& summary) {
  append(out, "{:22}", name);
  for (const Column& column : kColumns)
    append(out, " {:>9}", number(summary.mean[static_cast<std::size_t>(column.metric)], column));
  append(out, "\n");
}

std::string run_name(TemporalModel model, double alpha) {
  return fmt::format("{} alpha {} %", temporal_name(model), alpha);
}

std::string interval_text(const Interval& interval, const Column& column) {
  if (interval.sequences < 2) return number(interval.mean, column);
  return fmt::format("{} [{}, {}]", number(interval.mean, column), number(interval.low, column),
                     number(interval.high, column));
}

void add_line(std::string& out, const std::string& name, const MetricIntervals& metrics) {
  append(out, "{:26}", name);
  for (const Column& column : kSetColumns) {
    const auto metric = static_cast<std::size_t>(column.metric);
    append(out, " {:>20}", interval_text(metrics[metric], column));
  }
  append(out, "\n");
}

void add_titles(std::string& out, const std::string& name) {
  append(out, "{:26}", name);
  for (const Column& column : kSetColumns) append(out, " {:>20}", column.title);
  append(out, "\n");
}

std::string difference_name(const SetDifference& d) {
  if (d.alpha == d.minus_alpha) {
    return fmt::format("{} - {} at {} %", temporal_name(d.temporal),
                       temporal_name(d.minus_temporal), d.alpha);
  }
  return fmt::format("{}: {} % - {} %", temporal_name(d.temporal), d.alpha, d.minus_alpha);
}

void add_gap(std::string& out, const std::string& name, const Gap& gap, int decimals) {
  append(out, "{:30}", name);
  for (const double part : {gap.total(), gap.retrieval, gap.choice, gap.placement, gap.unanswered})
    append(out, " {:>10}", number(part, decimals));
  append(out, "  |");
  for (const double part : {gap.view, gap.pose}) append(out, " {:>8}", number(part, decimals));
  append(out, "\n");
}

void add_gaps(std::string& out, const std::vector<SetRun>& runs) {
  append(out, "\n{:30} {:>10} {:>10} {:>10} {:>10} {:>10}  | {:>8} {:>8}\n", "gap to the oracle",
         "total", "retrieval", "choice", "placement", "unanswered", "view", "pose");
  for (const SetRun& run : runs) {
    const std::string name = run_name(run.temporal, run.alpha);
    add_gap(out, name, run.pose_error_gap, 2);
    add_gap(out, name + ", mpjpe", run.mpjpe_gap, 1);
  }
}

void add_calibration(std::string& out, const std::vector<SetRun>& runs) {
  append(out, "\n{:30}", fmt::format("right to {} deg by confidence", kRecoveredDeg));
  for (std::size_t bin = 1; bin <= kCalibrationBins; ++bin)
    append(out, " {:>5}", fmt::format("-{:.1f}", static_cast<double>(bin) / kCalibrationBins));
  append(out, "   expected calibration error\n");
  for (const SetRun& run : runs) {
    append(out, "{:30}", run_name(run.temporal, run.alpha));
    for (const CalibrationBin& bin : run.calibration.bins)
      append(out, " {:>5}", bin.frames > 0 ? fmt::format("{:.2f}", bin.right) : "-");
    append(out, "   {:.3f}\n", run.calibration.expected_error);
  }
}

void add_recovery(std::string& out, const SetRecovery& recovery) {
  const Column frames{kMetricCount, "", 1};
  append(out,
         "after {} black frames {:8} recovers in {} of {} sequences; wrong frames until then {}\n",
         kBlackFrames, temporal_name(recovery.temporal), recovery.recovered, recovery.sequences,
         interval_text(recovery.frames, frames));
}

void add_far_grasps(std::string& out, int beyond, int frames) {
  append(out,
         "fingers are 5 degrees or more from the nearest pose of the database in {} of {} "
         "grasping frames\n",
         beyond, frames);
}

}  // namespace

std::string error_table(const std::vector<std::pair<std::string, Summary>>& answers,
                        const Baselines& baselines) {
  std::string out;
  append(out, "{:22}", "");
  for (const Column& column : kColumns) append(out, " {:>9}", column.title);
  append(out, "\n");
  for (const auto& [name, summary] : answers) add_line(out, name, summary);
  add_line(out, "oracle", baselines.oracle_mean);
  add_line(out, "random row", baselines.random);
  add_line(out, "best constant", baselines.constant);
  return out;
}

std::string sequence_table(const SequenceEvaluation& sequence) {
  std::string out;
  const EvalRun& first = sequence.runs.front();
  append(out,
         "\n{}, {} frames: smallest hand box {:.0f} px, {:.0f} % of frames valid at alpha {}\n",
         sequence.name, kind_name(sequence.kind), first.smallest_box_px, 100 * first.valid,
         first.alpha);
  if (sequence.kind == FrameKind::kPhotoreal) {
    const FindingMeans& found = sequence.found;
    append(out,
           "found hand against true hand: intersection over union {}, wrist off by {} mm, {} % "
           "missed\n",
           number(found.iou, 3), number(found.wrist_mm, 0), number(100 * found.missed, 0));
  }
  std::vector<std::pair<std::string, Summary>> lines;
  for (const EvalRun& run : sequence.runs)
    lines.emplace_back(run_name(run.temporal, run.alpha), run.errors);
  out += error_table(lines, sequence.baselines);
  add_far_grasps(out, sequence.beyond_5_deg, sequence.grasping_frames);
  return out;
}

std::string set_tables(const SetEvaluation& set, FrameKind kind, std::size_t sequences) {
  std::string out;
  append(out, "\nMeans over {} {} sequences with 95 % intervals\n", sequences, kind_name(kind));
  add_titles(out, "");
  for (const SetRun& run : set.runs) add_line(out, run_name(run.temporal, run.alpha), run.means);
  add_line(out, "oracle", set.oracle);
  add_line(out, "random row", set.random);
  add_line(out, "best constant", set.constant);
  append(out, "\n");
  add_titles(out, "paired differences");
  for (const SetDifference& difference : set.differences)
    add_line(out, difference_name(difference), difference.differences);
  add_gaps(out, set.runs);
  add_calibration(out, set.runs);
  append(out, "\n");
  for (const SetRecovery& recovery : set.recoveries) add_recovery(out, recovery);
  add_far_grasps(out, set.beyond_5_deg, set.grasping_frames);
  return out;
}

}  // namespace graspdb
