// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/gap.h"

#include <algorithm>

namespace graspdb {
namespace {

// The rotation of one pose, the hand of another.
Pose joined(const Pose& view, const Pose& hand) {
  const Eigen::Matrix3d turn = view.rotation * hand.rotation.transpose();
  return {view.rotation, hand.angles, turn * hand.joints};
}

void split_by_stage(const GapInput& in, PoseMetric metric, double answer, double best, Gap& gap) {
  if (in.hypotheses.empty()) {
    gap.unanswered = answer - best;
    return;
  }
  const auto error = [&](const Hypothesis& hypothesis) {
    const std::size_t pose = in.grid.pose_of(hypothesis.row),
                      view = in.grid.view_of(hypothesis.row);
    return metric(in.grid.seen(pose, view, in.truth, hypothesis.roll_deg), in.truth);
  };
  const double chosen = error(in.hypotheses.front());
  double retrieved = chosen;
  for (const Hypothesis& other : in.hypotheses.subspan(1))
    retrieved = std::min(retrieved, error(other));
  gap.retrieval = retrieved - best;
  gap.choice = chosen - retrieved;
  gap.placement = answer - chosen;
}

}  // namespace

Gap split_gap(const GapInput& in, PoseMetric metric) {
  const Pose oracle = in.grid.seen(in.best.pose, in.best.view, in.truth);
  const double answer = metric(in.answer, in.truth), best = metric(oracle, in.truth);
  Gap gap;
  split_by_stage(in, metric, answer, best, gap);
  const double best_view = metric(joined(oracle, in.answer), in.truth);
  const double best_pose = metric(joined(in.answer, oracle), in.truth);
  // Each part's gain is the mean of what it gains when mended first and when mended last (Shapley),
  // so that the two add up to the gap.
  gap.view = ((answer - best_view) + (best_pose - best)) / 2;
  gap.pose = ((answer - best_pose) + (best_view - best)) / 2;
  return gap;
}

Gap mean_gap(const std::vector<Gap>& frames) {
  Gap mean;
  for (double Gap::*part :
       {&Gap::retrieval, &Gap::choice, &Gap::placement, &Gap::unanswered, &Gap::view, &Gap::pose}) {
    for (const Gap& gap : frames) mean.*part += gap.*part / static_cast<double>(frames.size());
  }
  return mean;
}

}  // namespace graspdb
