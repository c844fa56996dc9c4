// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/evaluate.h"

namespace graspdb {

// What the runs of one sequence share.
struct Stage {
  const Database& database;
  const PoseGrid& grid;
  const SequenceFrames& frames;
  const EvalOptions& options;
  std::vector<Target> truth;  // a frame each
  const Baselines& baselines;
};

// One tracker on its way through the frames.
class Runner {
 public:
  Runner(const Stage& stage, const Search& search, const TrackerOptions& tracker);

  // Shows it the next frame.
  const FrameResult& step(const Mask& hand);
  EvalRun run(double alpha) const;

 private:
  void split_gaps(FrameResult& result, const std::vector<Hypothesis>& hypotheses) const;

  const Stage& stage_;
  TemporalModel model_;
  Tracker tracker_;
  Answer last_;
  std::vector<FrameResult> frames_;
  std::vector<Keypoints> joints_;
};

}  // namespace graspdb
