// SPDX-License-Identifier: MIT
// Runs the tracker over a rendered sequence and holds its answers against the truth, beside what
// the database could give at best, a random row and a constant guess.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/progress.h"
#include "graspdb/database/search.h"
#include "graspdb/evaluation/baselines.h"
#include "graspdb/evaluation/gap.h"
#include "graspdb/evaluation/metrics.h"
#include "graspdb/evaluation/pose_grid.h"
#include "graspdb/sequences/frames.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// Each temporal model once, with the options that were chosen for it.
std::vector<TrackerOptions> all_trackers(DescriptorKind kind);

struct EvalOptions {
  std::vector<TrackerOptions> trackers;  // none: all_trackers() for the database's rows
  std::vector<double> alphas = {0, 0.25, 0.5, 1, 2, 4};  // percent
  std::uint64_t seed = 0;
};

// One frame of a run. Without an answer the errors are those of the last one, at first of a flat
// hand without a turn before the camera: refusing hard frames must not pay.
struct FrameResult {
  bool valid = false;
  double confidence = 0;
  double distance = 0;    // of the nearest descriptor
  int box_height_px = 0;  // of the hand; 0 without a mask
  std::uint32_t row = 0;
  int grasp = 0;
  FrameErrors errors;
  Gap pose_error_gap, mpjpe_gap;
};

struct EvalRun {
  TemporalModel temporal = TemporalModel::kNone;
  double alpha = 0;  // percent
  std::vector<FrameResult> frames;
  Summary errors;  // with unsteadiness
  Gap pose_error_gap, mpjpe_gap;
  double valid = 0;            // the share of frames with an answer
  double smallest_box_px = 0;  // height of the smallest hand box
  double median_distance = 0;  // of the nearest descriptor
};

// At alpha 0, after frames without a hand in the middle of the sequence.
constexpr int kBlackFrames = 10;
constexpr double kRecoveredDeg = 30;
struct Recovery {
  TemporalModel temporal = TemporalModel::kNone;
  int frames = 0;  // shown before the rotation is right to kRecoveredDeg; all that are left
                   // when it never is
  bool recovered = false;
};

// Over the frames of a sequence; NaN when masks are true ones. docs/evaluation.md
struct FindingMeans {
  double iou = 0;       // of the found hand with the true one
  double missed = 0;    // share of the frames with a hand
  double imagined = 0;  // share of the frames without one
  double wrist_mm = 0;
};

struct SequenceEvaluation {
  std::string name;
  FrameKind kind = FrameKind::kRendered;
  std::optional<int> grasp_type;
  std::vector<FrameTruth> truth;  // a frame each, as the share of the hand that is hidden
  std::vector<double> occlusion;
  FindingMeans found;
  Baselines baselines;
  // Frames whose hand is closed at least half, and those of them whose fingers are 5 degrees or
  // more from the nearest pose of the database.
  int grasping_frames = 0, beyond_5_deg = 0;
  std::vector<EvalRun> runs;         // temporal model by temporal model, alpha by alpha
  std::vector<Recovery> recoveries;  // a temporal model each; none for a short sequence
};

constexpr double kGraspingClosure = 0.5;
constexpr double kTypeClosure = 0.8;  // from which the type of a grasp is asked for

// Uses all processors.
SequenceEvaluation evaluate(const Database& database, const PoseGrid& grid, const Search& search,
                            const SequenceFrames& frames, const EvalOptions& options,
                            const Progress& progress = {});

Pose pose_of(const FrameTruth& truth);
Answer answer_of(const Estimate& estimate, const Database& database);
// `grasp_type` counts from kTypeClosure on.
Target target_of(const FrameTruth& truth, const Intrinsics& camera, std::optional<int> grasp_type);

}  // namespace graspdb
