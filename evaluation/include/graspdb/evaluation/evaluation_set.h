// SPDX-License-Identifier: MIT
// A set of sequences as one: means and differences with intervals over sequences, calibration,
// recovery.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "graspdb/evaluation/bootstrap.h"
#include "graspdb/evaluation/evaluate.h"

namespace graspdb {

using MetricIntervals = std::array<Interval, kRunMetricCount>;

// Whether the confidence is what it says: the share of answers whose rotation is right to
// kRecoveredDeg. Over frames with an answer.
struct CalibrationBin {
  std::size_t frames = 0;
  double confidence = 0, right = 0;  // means; NaN without frames
};
constexpr std::size_t kCalibrationBins = 10;  // equally wide, from 0 to 1
struct Calibration {
  double expected_error = 0;  // the mean over frames of |confidence - right| of their bins; NaN
                              // without frames
  std::array<CalibrationBin, kCalibrationBins> bins;
};
Calibration calibrate(const std::vector<const EvalRun*>& runs);

struct SetRun {
  TemporalModel temporal = TemporalModel::kNone;
  double alpha = 0;
  MetricIntervals means;  // over sequences of the mean over frames
  Gap pose_error_gap, mpjpe_gap;
  Calibration calibration;
};

struct SetDifference {
  TemporalModel temporal = TemporalModel::kNone, minus_temporal = TemporalModel::kNone;
  double alpha = 0, minus_alpha = 0;
  MetricIntervals differences;  // paired by sequence
};

struct SetRecovery {
  TemporalModel temporal = TemporalModel::kNone;
  std::size_t sequences = 0, recovered = 0;
  Interval frames;  // those that never recover count with all frames that were left
};

struct SetEvaluation {
  MetricIntervals oracle, random, constant;
  std::vector<SetRun> runs;
  // At each alpha kde - gaussian, gaussian - none, kde - none, successors - kde; then for each
  // model alpha 2 % - 0.
  std::vector<SetDifference> differences;
  std::vector<SetRecovery> recoveries;
  int grasping_frames = 0, beyond_5_deg = 0;
};

// All sequences were evaluated with the same options. Throws std::logic_error when they were not.
SetEvaluation summarize_set(const std::vector<SequenceEvaluation>& sequences, std::uint64_t seed);

}  // namespace graspdb
