// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "graspdb/evaluation/eval_files.h"

namespace graspdb {
namespace {

// Lines of cells; an empty cell is a value that does not apply.
class Csv {
 public:
  void cell(const std::string& text) {
    if (!at_start_) text_ += ',';
    text_ += text;
    at_start_ = false;
  }
  void cell(double value) { cell(std::isnan(value) ? "" : fmt::format("{:.7g}", value)); }
  void end_line() {
    text_ += '\n';
    at_start_ = true;
  }
  void line(const std::vector<std::string>& names) {
    for (const std::string& name : names) cell(name);
    end_line();
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
  bool at_start_ = true;
};

// A sequence's name is the user's own text.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

void add_names(std::vector<std::string>& names, const std::string& prefix, int count) {
  for (int m = 0; m < count; ++m) names.push_back(prefix + std::string(metric_info(m).name));
}

template <typename Errors>
void add_errors(Csv& csv, const Errors& errors, std::size_t count) {
  for (std::size_t m = 0; m < count; ++m) csv.cell(errors[m]);
}

double or_nan(const std::optional<int>& value) {
  return value ? *value : std::nan("");
}

void begin_line(Csv& csv, const SequenceEvaluation& sequence, const EvalRun& run) {
  csv.cell(quoted(sequence.name));
  csv.cell(kind_name(sequence.kind));
  csv.cell(temporal_name(run.temporal));
  csv.cell(run.alpha);
}

void frame_line(Csv& csv, const SequenceEvaluation& sequence, const EvalRun& run, std::size_t i) {
  const FrameResult& frame = run.frames[i];
  const FrameTruth& truth = sequence.truth[i];
  begin_line(csv, sequence, run);
  csv.cell(std::to_string(i));
  csv.cell(truth.time);
  csv.cell(frame.valid);
  csv.cell(frame.confidence);
  csv.cell(frame.valid ? frame.distance : std::nan(""));
  csv.cell(truth.closure);
  csv.cell(sequence.occlusion[i]);
  csv.cell(frame.box_height_px);
  csv.cell(frame.valid ? frame.row : std::nan(""));
  csv.cell(frame.valid ? frame.grasp : std::nan(""));
  csv.cell(or_nan(sequence.grasp_type));
  add_errors(csv, frame.errors, kMetricCount);
  add_errors(csv, sequence.baselines.oracle[i].errors, kMetricCount);
  csv.end_line();
}

void add_gap(Csv& csv, const Gap& gap) {
  for (const double part :
       {gap.retrieval, gap.choice, gap.placement, gap.unanswered, gap.view, gap.pose})
    csv.cell(part);
}

void add_recovery(Csv& csv, const SequenceEvaluation& sequence, TemporalModel model) {
  for (const Recovery& recovery : sequence.recoveries) {
    if (recovery.temporal != model) continue;
    csv.cell(recovery.frames);
    csv.cell(recovery.recovered);
    return;
  }
  csv.cell("");
  csv.cell("");
}

void run_line(Csv& csv, const SequenceEvaluation& sequence, const EvalRun& run) {
  begin_line(csv, sequence, run);
  csv.cell(or_nan(sequence.grasp_type));
  csv.cell(static_cast<double>(run.frames.size()));
  csv.cell(run.valid);
  csv.cell(run.smallest_box_px);
  csv.cell(run.median_distance);
  csv.cell(sequence.found.iou);
  csv.cell(sequence.found.missed);
  csv.cell(sequence.found.imagined);
  csv.cell(sequence.found.wrist_mm);
  csv.cell(sequence.grasping_frames);
  csv.cell(sequence.beyond_5_deg);
  add_recovery(csv, sequence, run.temporal);
  csv.cell(run.errors.rotation_deg.median);
  csv.cell(run.errors.rotation_deg.p90);
  add_gap(csv, run.pose_error_gap);
  add_gap(csv, run.mpjpe_gap);
  add_errors(csv, run.errors.mean, kRunMetricCount);
  const Baselines& base = sequence.baselines;
  for (const Summary* summary : {&base.oracle_mean, &base.random, &base.constant})
    add_errors(csv, summary->mean, kRunMetricCount);
  csv.end_line();
}

}  // namespace

std::string frames_csv(const EvalReport& report) {
  Csv csv;
  std::vector<std::string> names = {"sequence", "kind",    "temporal",  "alpha",
                                    "frame",    "time_s",  "valid",     "confidence",
                                    "distance", "closure", "occlusion", "box_height_px",
                                    "row",      "grasp",   "grasp_type"};
  add_names(names, "", kMetricCount);
  add_names(names, "oracle_", kMetricCount);
  csv.line(names);
  for (const SequenceEvaluation& sequence : report.sequences) {
    for (const EvalRun& run : sequence.runs) {
      for (std::size_t i = 0; i < run.frames.size(); ++i) frame_line(csv, sequence, run, i);
    }
  }
  return std::move(csv).text();
}

std::string runs_csv(const EvalReport& report) {
  Csv csv;
  std::vector<std::string> names = {"sequence",        "kind",
                                    "temporal",        "alpha",
                                    "grasp_type",      "frames",
                                    "valid",           "smallest_box_px",
                                    "median_distance", "segmentation_iou",
                                    "missed_hands",    "imagined_hands",
                                    "wrist_cut_mm",    "grasping_frames",
                                    "beyond_5_deg",    "recovery_frames",
                                    "recovered",       "rotation_deg_median",
                                    "rotation_deg_p90"};
  for (const std::string metric : {"pose_error", "mpjpe_mm"}) {
    for (const char* part : {"retrieval", "choice", "placement", "unanswered", "view", "pose"})
      names.push_back(fmt::format("{}_gap_{}", metric, part));
  }
  add_names(names, "", kRunMetricCount);
  for (const char* prefix : {"oracle_", "random_", "constant_"})
    add_names(names, prefix, kRunMetricCount);
  csv.line(names);
  for (const SequenceEvaluation& sequence : report.sequences) {
    for (const EvalRun& run : sequence.runs) run_line(csv, sequence, run);
  }
  return std::move(csv).text();
}

}  // namespace graspdb
