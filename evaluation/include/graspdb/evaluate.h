// SPDX-License-Identifier: MIT
// Runs the tracker over a rendered sequence and holds its answers against the truth, beside what
// the database could give at best, a random row and a constant guess.
#pragma once

#include <string>
#include <vector>

#include "graspdb/database.h"
#include "graspdb/metrics.h"
#include "graspdb/progress.h"
#include "graspdb/search.h"
#include "graspdb/sequence.h"
#include "graspdb/tracker.h"

namespace graspdb {

// What frames with the same truth give without looking at the picture.
struct Baselines {
  Summary oracle;    // for each metric and frame its own best row
  Summary random;    // mean over random rows
  Summary constant;  // the view and the pose that, kept all the time, are best for this sequence
  // From each frame's fingers to the nearest pose of the database, mean joint difference, degrees.
  Spread nearest_pose_deg;
  double share_beyond_5_deg = 0;  // of frames
};
Baselines baselines(const Database& database, const std::vector<FrameTruth>& truth,
                    std::uint64_t seed);

struct EvalOptions {
  std::vector<TemporalModel> temporal = {TemporalModel::kNone, TemporalModel::kGaussian,
                                         TemporalModel::kKde};
  std::vector<double> alphas = {0, 0.25, 0.5, 1, 2, 4};  // percent
  TrackerOptions tracker;                                // its temporal model is replaced
  std::uint64_t seed = 0;
};

struct EvalRow {
  std::string sequence;
  TemporalModel temporal = TemporalModel::kNone;
  double alpha = 0;
  Summary errors;              // over all frames; without an answer the last one stands
  double valid = 0;            // their share
  double smallest_box_px = 0;  // height of the smallest hand box
  double median_distance = 0;  // of the nearest descriptor
};

struct SequenceEvaluation {
  Baselines baselines;
  std::vector<EvalRow> rows;  // temporal model by temporal model, alpha by alpha
};

SequenceEvaluation evaluate(const Database& database, const Search& search,
                            const SequenceRenderer& sequence, const EvalOptions& options,
                            const Progress& progress = {});

Pose pose_of(const FrameTruth& truth);
Pose pose_of(const Estimate& estimate);

std::string temporal_name(TemporalModel model);             // "none", "gaussian", "kde"
TemporalModel temporal_from_name(const std::string& name);  // throws Error

}  // namespace graspdb
