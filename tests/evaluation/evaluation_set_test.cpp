// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/evaluation_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace graspdb {
namespace {

FrameResult frame(double confidence, double rotation_deg, bool valid = true) {
  FrameResult result{.valid = valid, .confidence = confidence};
  result.errors.fill(0);
  result.errors[kRotationDeg] = rotation_deg;
  return result;
}

EvalRun run(TemporalModel temporal, double alpha, double mpjpe) {
  EvalRun run{.temporal = temporal, .alpha = alpha};
  run.errors.mean.fill(std::nan(""));
  run.errors.mean[kMpjpeMm] = mpjpe;
  return run;
}

// Three sequences of other difficulty: kde is 2 mm better than gaussian, gaussian 1 mm better than
// none, and noise costs 5 mm.
std::vector<SequenceEvaluation> three_sequences() {
  std::vector<SequenceEvaluation> all;
  for (const double base : {10.0, 30.0, 80.0}) {
    SequenceEvaluation sequence;
    sequence.baselines.oracle_mean.mean.fill(base / 2);
    for (const auto& [model, gain] : {std::pair(TemporalModel::kNone, 0.0),
                                      {TemporalModel::kGaussian, 1.0},
                                      {TemporalModel::kKde, 3.0}}) {
      sequence.runs.push_back(run(model, 0, base - gain));
      sequence.runs.push_back(run(model, 2, base - gain + 5));
      sequence.recoveries.push_back({model, static_cast<int>(base / 10), base < 50});
    }
    all.push_back(sequence);
  }
  return all;
}

TEST(Calibration, OfAConfidenceThatIsRightIsZero) {
  EvalRun run;
  for (int i = 0; i < 4; ++i) run.frames.push_back(frame(0.75, i < 3 ? 10 : 50));
  const Calibration found = calibrate({&run});
  EXPECT_NEAR(found.expected_error, 0, 1e-12);
  EXPECT_EQ(found.bins[7].frames, 4U);
  EXPECT_DOUBLE_EQ(found.bins[7].right, 0.75);
  EXPECT_TRUE(std::isnan(found.bins[0].right));
}

TEST(Calibration, BinsAreWeightedByTheirFrames) {
  EvalRun sure, unsure;
  for (int i = 0; i < 3; ++i) sure.frames.push_back(frame(1, 40));  // off by 1, the last bin
  unsure.frames.push_back(frame(0.2, 29));                          // off by 0.8
  unsure.frames.push_back(frame(0.9, 0, false));                    // no answer, not counted
  EXPECT_NEAR(calibrate({&sure, &unsure}).expected_error, (3 * 1 + 0.8) / 4, 1e-12);
  EXPECT_TRUE(std::isnan(calibrate({}).expected_error));
}

TEST(EvaluationSet, MeansAreOverSequences) {
  const SetEvaluation set = summarize_set(three_sequences(), 1);
  ASSERT_EQ(set.runs.size(), 6U);
  EXPECT_EQ(set.runs[0].temporal, TemporalModel::kNone);
  EXPECT_EQ(set.runs[0].means[kMpjpeMm].mean, 40);
  EXPECT_LT(set.runs[0].means[kMpjpeMm].low, 30);
  EXPECT_EQ(set.runs[1].alpha, 2);
  EXPECT_EQ(set.oracle[kMpjpeMm].mean, 20);
  EXPECT_EQ(set.runs[0].means[kGraspTop1].sequences, 0U);
}

TEST(EvaluationSet, DifferencesArePairedBySequence) {
  const SetEvaluation set = summarize_set(three_sequences(), 1);
  ASSERT_EQ(set.differences.size(), 9U);  // three pairs at two alphas, three models
  const auto expect = [&](std::size_t i, TemporalModel a, TemporalModel b, double difference) {
    EXPECT_EQ(set.differences[i].temporal, a);
    EXPECT_EQ(set.differences[i].minus_temporal, b);
    const Interval& interval = set.differences[i].differences[kMpjpeMm];
    EXPECT_NEAR(interval.mean, difference, 1e-9);
    EXPECT_NEAR(interval.low, difference, 1e-9);  // the same in every sequence
    EXPECT_NEAR(interval.high, difference, 1e-9);
  };
  expect(0, TemporalModel::kKde, TemporalModel::kGaussian, -2);
  expect(1, TemporalModel::kGaussian, TemporalModel::kNone, -1);
  expect(5, TemporalModel::kKde, TemporalModel::kNone, -3);
  expect(8, TemporalModel::kKde, TemporalModel::kKde, 5);
  EXPECT_EQ(set.differences[8].alpha, 2);
  EXPECT_EQ(set.differences[8].minus_alpha, 0);
}

TEST(EvaluationSet, WhatWasNotRunIsNotCompared) {
  SequenceEvaluation sequence;
  sequence.runs = {run(TemporalModel::kKde, 1, 3)};
  EXPECT_TRUE(summarize_set({sequence}, 0).differences.empty());
}

TEST(EvaluationSet, SequencesThatNeverRecoverCountWithWhatWasLeft) {
  const SetEvaluation set = summarize_set(three_sequences(), 1);
  ASSERT_EQ(set.recoveries.size(), 3U);
  EXPECT_EQ(set.recoveries[2].temporal, TemporalModel::kKde);
  EXPECT_EQ(set.recoveries[2].sequences, 3U);
  EXPECT_EQ(set.recoveries[2].recovered, 2U);
  EXPECT_EQ(set.recoveries[2].frames.mean, 4);
}

}  // namespace
}  // namespace graspdb
