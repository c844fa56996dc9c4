// SPDX-License-Identifier: MIT
#include <algorithm>

#include "graspdb/evaluation/eval_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

std::string name_of(std::size_t metric) {
  return std::string(metric_info(static_cast<int>(metric)).name);
}

json to_json(const Summary& summary) {
  json line;
  for (std::size_t m = 0; m < kRunMetricCount; ++m) line[name_of(m)] = summary.mean[m];
  line["rotation_deg"] = {{"mean", summary.rotation_deg.mean},
                          {"median", summary.rotation_deg.median},
                          {"p90", summary.rotation_deg.p90}};
  return line;
}

json to_json(const Interval& interval) {
  return {{"mean", interval.mean},
          {"low", interval.low},
          {"high", interval.high},
          {"sequences", interval.sequences}};
}

json to_json(const MetricIntervals& metrics) {
  json all;
  for (std::size_t m = 0; m < kRunMetricCount; ++m) all[name_of(m)] = to_json(metrics[m]);
  return all;
}

json to_json(const Gap& gap) {
  return {{"total", gap.total()},
          {"stage",
           {{"retrieval", gap.retrieval},
            {"choice", gap.choice},
            {"placement", gap.placement},
            {"unanswered", gap.unanswered}}},
          {"part", {{"view", gap.view}, {"pose", gap.pose}}}};
}

template <typename Run>
json gaps(const Run& run) {
  return {{"pose_error", to_json(run.pose_error_gap)}, {"mpjpe_mm", to_json(run.mpjpe_gap)}};
}

json to_json(const Recovery& recovery) {
  return {{"frames", recovery.frames}, {"recovered", recovery.recovered}};
}

json to_json(const SequenceEvaluation& sequence, const EvalRun& run) {
  json line = to_json(run.errors);
  line.update({{"sequence", sequence.name},
               {"grasp_type", nullptr},
               {"temporal", temporal_name(run.temporal)},
               {"alpha", run.alpha},
               {"frames", run.frames.size()},
               {"valid", run.valid},
               {"smallest_box_px", run.smallest_box_px},
               {"median_distance", run.median_distance},
               {"segmentation_iou", sequence.found.iou},
               {"missed_hands", sequence.found.missed},
               {"imagined_hands", sequence.found.imagined},
               {"wrist_cut_mm", sequence.found.wrist_mm},
               {"grasping_frames", sequence.grasping_frames},
               {"beyond_5_deg", sequence.beyond_5_deg},
               {"oracle", to_json(sequence.baselines.oracle_mean)},
               {"random", to_json(sequence.baselines.random)},
               {"constant", to_json(sequence.baselines.constant)},
               {"gap", gaps(run)}});
  if (sequence.grasp_type) line["grasp_type"] = *sequence.grasp_type;
  for (const Recovery& recovery : sequence.recoveries) {
    if (recovery.temporal == run.temporal) line["recovery"] = to_json(recovery);
  }
  return line;
}

json to_json(const Calibration& calibration) {
  json bins = json::array();
  for (std::size_t i = 0; i < kCalibrationBins; ++i) {
    const CalibrationBin& bin = calibration.bins[i];
    bins.push_back({{"from", static_cast<double>(i) / kCalibrationBins},
                    {"to", static_cast<double>(i + 1) / kCalibrationBins},
                    {"frames", bin.frames},
                    {"confidence", bin.confidence},
                    {"right", bin.right}});
  }
  return {{"expected_error", calibration.expected_error}, {"bins", std::move(bins)}};
}

json to_json(const SetRun& run) {
  return {{"temporal", temporal_name(run.temporal)},
          {"alpha", run.alpha},
          {"means", to_json(run.means)},
          {"gap", gaps(run)},
          {"calibration", to_json(run.calibration)}};
}

json to_json(const SetDifference& difference) {
  return {
      {"temporal", temporal_name(difference.temporal)},
      {"alpha", difference.alpha},
      {"minus",
       {{"temporal", temporal_name(difference.minus_temporal)}, {"alpha", difference.minus_alpha}}},
      {"differences", to_json(difference.differences)}};
}

json to_json(const SetRecovery& recovery) {
  return {{"temporal", temporal_name(recovery.temporal)},
          {"sequences", recovery.sequences},
          {"recovered", recovery.recovered},
          {"frames", to_json(recovery.frames)}};
}

template <typename Value>
json list(const std::vector<Value>& values) {
  json all = json::array();
  for (const Value& value : values) all.push_back(to_json(value));
  return all;
}

json to_json(const SetEvaluation& set) {
  return {{"oracle", to_json(set.oracle)},          {"random", to_json(set.random)},
          {"constant", to_json(set.constant)},      {"runs", list(set.runs)},
          {"differences", list(set.differences)},   {"recovery", list(set.recoveries)},
          {"grasping_frames", set.grasping_frames}, {"beyond_5_deg", set.beyond_5_deg}};
}

json metric_table() {
  json all = json::array();
  for (std::size_t m = 0; m < kRunMetricCount; ++m) {
    const MetricInfo& info = metric_info(static_cast<int>(m));
    all.push_back(
        {{"name", info.name}, {"unit", info.unit}, {"more_is_better", info.more_is_better}});
  }
  return all;
}

}  // namespace

nlohmann::json options_json(const TrackerOptions& options) {
  nlohmann::json all;
  for (const TrackerNumber& number : kTrackerNumbers)
    std::visit([&](auto member) { all[number.key] = options.*member; }, number.member);
  return all;
}

json eval_json(const EvalReport& report) {
  json rows = json::array();
  for (const SequenceEvaluation& sequence : report.sequences) {
    for (const EvalRun& run : sequence.runs) rows.push_back(to_json(sequence, run));
  }
  return {{"kind", kind_name(report.sequences.front().kind)},
          {"rows", std::move(rows)},
          {"set", to_json(report.set)},
          {"metrics", metric_table()}};
}

}  // namespace graspdb
