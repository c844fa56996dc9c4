// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/evaluation_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "nan.h"

namespace graspdb {
namespace {

constexpr double kNoisyAlpha = 2;  // percent, up to which the paper's error hardly rises

using Sequences = std::vector<SequenceEvaluation>;

// One value a sequence.
template <typename Value>
MetricIntervals intervals(const Sequences& sequences, std::uint64_t seed, const Value& value) {
  MetricIntervals result;
  std::vector<double> values(sequences.size());
  for (std::size_t metric = 0; metric < kRunMetricCount; ++metric) {
    for (std::size_t s = 0; s < values.size(); ++s) values[s] = value(sequences[s], metric);
    result[metric] = bootstrap_mean(values, seed);
  }
  return result;
}

MetricIntervals baseline(const Sequences& sequences, std::uint64_t seed,
                         Summary Baselines::*which) {
  return intervals(sequences, seed, [which](const SequenceEvaluation& sequence, std::size_t m) {
    return (sequence.baselines.*which).mean[m];
  });
}

std::vector<const EvalRun*> same_run(const Sequences& sequences, std::size_t run) {
  std::vector<const EvalRun*> runs;
  for (const SequenceEvaluation& sequence : sequences) {
    const EvalRun& first = sequences.front().runs[run];
    GRASPDB_CHECK(sequence.runs.size() == sequences.front().runs.size() &&
                  sequence.runs[run].temporal == first.temporal &&
                  sequence.runs[run].alpha == first.alpha);
    runs.push_back(&sequence.runs[run]);
  }
  return runs;
}

Gap mean_gap_of(const std::vector<const EvalRun*>& runs, Gap EvalRun::*which) {
  std::vector<Gap> gaps;
  for (const EvalRun* run : runs) gaps.push_back(run->*which);
  return mean_gap(gaps);
}

SetRun set_run(const Sequences& sequences, std::size_t run, std::uint64_t seed) {
  const std::vector<const EvalRun*> runs = same_run(sequences, run);
  return {runs.front()->temporal,
          runs.front()->alpha,
          intervals(sequences, seed,
                    [run](const SequenceEvaluation& sequence, std::size_t m) {
                      return sequence.runs[run].errors.mean[m];
                    }),
          mean_gap_of(runs, &EvalRun::pose_error_gap),
          mean_gap_of(runs, &EvalRun::mpjpe_gap),
          calibrate(runs)};
}

// Adds a - b when both were run.
void add_difference(const Sequences& sequences, std::uint64_t seed, SetDifference difference,
                    std::vector<SetDifference>& all) {
  const auto& runs = sequences.front().runs;
  const auto place = [&runs](TemporalModel temporal, double alpha) {
    const auto found = std::find_if(runs.begin(), runs.end(), [&](const EvalRun& run) {
      return run.temporal == temporal && run.alpha == alpha;
    });
    return static_cast<std::size_t>(found - runs.begin());
  };
  const std::size_t a = place(difference.temporal, difference.alpha);
  const std::size_t b = place(difference.minus_temporal, difference.minus_alpha);
  if (a == runs.size() || b == runs.size()) return;
  difference.differences =
      intervals(sequences, seed, [a, b](const SequenceEvaluation& sequence, std::size_t m) {
        return sequence.runs[a].errors.mean[m] - sequence.runs[b].errors.mean[m];
      });
  all.push_back(difference);
}

std::vector<SetDifference> all_differences(const Sequences& sequences, std::uint64_t seed) {
  constexpr auto kNone = TemporalModel::kNone, kGaussian = TemporalModel::kGaussian,
                 kKde = TemporalModel::kKde, kSuccessors = TemporalModel::kSuccessors;
  std::vector<double> alphas;
  for (const EvalRun& run : sequences.front().runs) {
    if (std::find(alphas.begin(), alphas.end(), run.alpha) == alphas.end())
      alphas.push_back(run.alpha);
  }
  std::vector<SetDifference> all;
  for (const double alpha : alphas) {
    for (const auto& [a, b] :
         {std::pair(kKde, kGaussian), {kGaussian, kNone}, {kKde, kNone}, {kSuccessors, kKde}})
      add_difference(sequences, seed, {a, b, alpha, alpha, {}}, all);
  }
  for (const TemporalModel model : kTemporalModels)
    add_difference(sequences, seed, {model, model, kNoisyAlpha, 0, {}}, all);
  return all;
}

std::vector<SetRecovery> all_recoveries(const Sequences& sequences, std::uint64_t seed) {
  std::vector<SetRecovery> all;
  std::vector<std::vector<double>> frames;
  for (const SequenceEvaluation& sequence : sequences) {
    for (std::size_t i = 0; i < sequence.recoveries.size(); ++i) {
      const Recovery& recovery = sequence.recoveries[i];
      if (i == all.size()) {
        all.push_back({.temporal = recovery.temporal});
        frames.emplace_back();
      }
      GRASPDB_CHECK(all[i].temporal == recovery.temporal);
      ++all[i].sequences;
      all[i].recovered += recovery.recovered ? 1 : 0;
      frames[i].push_back(recovery.frames);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].frames = bootstrap_mean(frames[i], seed);
  return all;
}

}  // namespace

Calibration calibrate(const std::vector<const EvalRun*>& runs) {
  Calibration result;
  std::size_t frames = 0;
  for (const EvalRun* run : runs) {
    for (const FrameResult& frame : run->frames) {
      if (!frame.valid) continue;
      const auto bin = static_cast<std::size_t>(frame.confidence * kCalibrationBins);
      CalibrationBin& in = result.bins[std::min(bin, kCalibrationBins - 1)];
      ++in.frames;
      in.confidence += frame.confidence;
      in.right += frame.errors[kRotationDeg] <= kRecoveredDeg;
      ++frames;
    }
  }
  for (CalibrationBin& bin : result.bins) {
    // Sums so far: divided by all frames they are the bin's share of the error.
    result.expected_error += std::abs(bin.confidence - bin.right);
    const auto count = static_cast<double>(bin.frames);
    bin.confidence = bin.frames > 0 ? bin.confidence / count : kNan;
    bin.right = bin.frames > 0 ? bin.right / count : kNan;
  }
  result.expected_error = frames > 0 ? result.expected_error / static_cast<double>(frames) : kNan;
  return result;
}

SetEvaluation summarize_set(const Sequences& sequences, std::uint64_t seed) {
  GRASPDB_CHECK(!sequences.empty());
  SetEvaluation set;
  set.oracle = baseline(sequences, seed, &Baselines::oracle_mean);
  set.random = baseline(sequences, seed, &Baselines::random);
  set.constant = baseline(sequences, seed, &Baselines::constant);
  for (std::size_t run = 0; run < sequences.front().runs.size(); ++run)
    set.runs.push_back(set_run(sequences, run, seed));
  set.differences = all_differences(sequences, seed);
  set.recoveries = all_recoveries(sequences, seed);
  for (const SequenceEvaluation& sequence : sequences) {
    set.grasping_frames += sequence.grasping_frames;
    set.beyond_5_deg += sequence.beyond_5_deg;
  }
  return set;
}

}  // namespace graspdb
