// SPDX-License-Identifier: MIT
// Why an answer is worse than the best row of the database: two splits of the gap, each of which
// adds up to it. docs/evaluation.md explains them.
#pragma once

#include <span>
#include <vector>

#include "graspdb/evaluation/baselines.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

using PoseMetric = double (*)(const Pose& estimate, const Pose& truth);

struct Gap {
  // By stage.
  // Best of the rows that were retrieved, less the oracle; >= 0 but where a rolled look found what
  // the oracle, which looks at the frame as it is, does not.
  double retrieval = 0;
  double choice = 0;      // the row that was chosen, less the best of the retrieved ones; >= 0
  double placement = 0;   // the answer, less its row seen where the palm truly is
  double unanswered = 0;  // the whole gap of a frame without an answer
  // By part: what the oracle's view and the oracle's pose would each have mended.
  double view = 0;
  double pose = 0;

  double total() const { return retrieval + choice + placement + unanswered; }
};

struct GapInput {
  const PoseGrid& grid;
  const Pose& truth;
  const Pose& answer;                      // without an answer: what stands for it
  std::span<const Hypothesis> hypotheses;  // retrieved, the chosen one first; none: no answer
  GridPlace best;                          // the row that gives the oracle
};
Gap split_gap(const GapInput& input, PoseMetric metric);

Gap mean_gap(const std::vector<Gap>& frames);  // all 0 for no frames

}  // namespace graspdb
