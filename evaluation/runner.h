// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "graspdb/evaluation/evaluate.h"
#include "graspdb/tracker/hand_reader.h"

namespace graspdb {

// What the runs of one sequence share.
struct Stage {
  const Database& database;
  const PoseGrid& grid;
  const SequenceFrames& frames;
  const EvalOptions& options;
  std::vector<Target> truth;  // a frame each
  const Baselines& baselines;
  std::shared_ptr<const Describer> describer;
};

// One tracker on its way through the frames.
class Runner {
 public:
  Runner(const Stage& stage, const Search& search, const TrackerOptions& tracker);

  const HandReader& reader() const { return reader_; }
  // Shows it the next frame.
  void step(const Observation& seen);
  const FrameResult& last() const { return frames_.back(); }
  EvalRun run(double alpha) const;

 private:
  void split_gaps(FrameResult& result, const std::vector<Hypothesis>& hypotheses) const;

  const Stage& stage_;
  TemporalModel model_;
  HandReader reader_;
  Answer last_answer_;
  std::vector<FrameResult> frames_;
  std::vector<Keypoints> joints_;
};

}  // namespace graspdb
