// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/sequences/noise.h"
#include "runner.h"

namespace graspdb {
namespace {

// The trackers look the same frame up one after another: only the first one searches, for as many
// rows as any of them wants. Not thread-safe.
class SharedSearch : public Search {
 public:
  SharedSearch(const Search& search, const std::vector<TrackerOptions>& trackers)
      : search_(search) {
    for (const TrackerOptions& tracker : trackers) most_ = std::max(most_, tracker.neighbors);
  }
  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    return nearest_of_each(std::span(&query, 1), k).front();
  }
  std::vector<std::vector<Neighbor>> nearest_of_each(std::span<const DescriptorView> queries,
                                                     int k) const override {
    GRASPDB_CHECK(k <= most_);
    if (!std::ranges::equal(queries, queries_, std::ranges::equal)) {
      queries_.clear();
      for (const DescriptorView query : queries) queries_.emplace_back(query.begin(), query.end());
      found_ = search_.nearest_of_each(queries, most_);
    }
    std::vector<std::vector<Neighbor>> first;
    for (const std::vector<Neighbor>& found : found_) {
      const auto count = std::min(found.size(), static_cast<std::size_t>(k));
      first.emplace_back(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return first;
  }

 private:
  const Search& search_;
  int most_ = 0;
  mutable std::vector<DescriptorBytes> queries_;
  mutable std::vector<std::vector<Neighbor>> found_;
};

void count_far_grasps(SequenceEvaluation& result) {
  for (std::size_t i = 0; i < result.truth.size(); ++i) {
    if (result.truth[i].closure < kGraspingClosure) continue;
    ++result.grasping_frames;
    if (result.baselines.oracle[i].errors[kJointDeg] >= 5) ++result.beyond_5_deg;
  }
}

std::vector<Runner> runners(const Stage& stage, const Search& search) {
  std::vector<Runner> all;
  for (const TrackerOptions& tracker : stage.options.trackers)
    all.emplace_back(stage, search, tracker);
  return all;
}

Observation observe(const HandReader& reader, const SequenceFrames& frames, std::size_t i,
                    const Mask& mask) {
  if (frames.arm.empty()) return reader.observe(frames.gray[i], mask, frames.camera);
  Observation seen{frames.gray[i], mask, frames.camera};
  seen.towards_arm = arm_direction({mask, frames.arm[i]});
  return seen;
}

// The hand is cut out once for all of them.
void show(std::vector<Runner>& models, const SequenceFrames& frames, std::size_t i,
          const Mask& mask) {
  const Observation seen = observe(models.front().reader(), frames, i, mask);
  for (Runner& model : models) model.step(seen);
}

// A run of each temporal model, side by side.
std::vector<EvalRun> run_all(const Stage& stage, const Search& search, double alpha) {
  const SharedSearch shared(search, stage.options.trackers);
  std::vector<Runner> models = runners(stage, shared);
  for (std::size_t i = 0; i < stage.frames.hand.size(); ++i) {
    const Mask noisy = add_segmentation_noise(stage.frames.hand[i], alpha, stage.options.seed, i);
    show(models, stage.frames, i, noisy);
  }
  std::vector<EvalRun> runs;
  for (const Runner& model : models) runs.push_back(model.run(alpha));
  return runs;
}

std::vector<Recovery> recover(const Stage& stage, const Search& search) {
  const std::size_t count = stage.frames.hand.size();
  if (count <= kBlackFrames) return {};
  const std::size_t black = (count - kBlackFrames) / 2, seen_again = black + kBlackFrames;
  const SharedSearch shared(search, stage.options.trackers);
  std::vector<Runner> models = runners(stage, shared);
  std::vector<Recovery> recoveries;
  for (const TrackerOptions& tracker : stage.options.trackers)
    recoveries.push_back({tracker.temporal, 0, false});
  const Mask nothing(stage.frames.camera.width, stage.frames.camera.height);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_black = i >= black && i < seen_again;
    show(models, stage.frames, i, is_black ? nothing : stage.frames.hand[i]);
    for (std::size_t m = 0; m < models.size(); ++m) {
      const FrameResult& frame = models[m].last();
      if (i < seen_again || recoveries[m].recovered) continue;
      recoveries[m].recovered = frame.valid && frame.errors[kRotationDeg] <= kRecoveredDeg;
      if (!recoveries[m].recovered) ++recoveries[m].frames;
    }
  }
  return recoveries;
}

void run_everything(const Stage& stage, const Search& search, const Progress& progress,
                    SequenceEvaluation& result) {
  const auto& alphas = stage.options.alphas;
  const std::size_t models = stage.options.trackers.size(), tasks = alphas.size() + 1;
  result.runs.resize(models * alphas.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(tasks, 0, [&](std::size_t task) {
    if (task == alphas.size()) {
      result.recoveries = recover(stage, search);
    } else {
      std::vector<EvalRun> runs = run_all(stage, search, alphas[task]);
      for (std::size_t m = 0; m < models; ++m)
        result.runs[m * alphas.size() + task] = std::move(runs[m]);
    }
    const std::scoped_lock lock(mutex);
    if (progress) progress(++done, tasks);
  });
}

FindingMeans means_of(const std::vector<Finding>& found) {
  std::vector<double> iou, missed, imagined, wrist_mm;
  for (const Finding& finding : found) {
    const bool is_there = finding.missed || (!std::isnan(finding.iou) && !finding.imagined);
    (is_there ? missed : imagined).push_back(is_there ? finding.missed : finding.imagined);
    iou.push_back(finding.iou);
    wrist_mm.push_back(finding.wrist_mm);
  }
  return {mean_of_numbers(iou), mean_of_numbers(missed), mean_of_numbers(imagined),
          mean_of_numbers(wrist_mm)};
}

}  // namespace

SequenceEvaluation evaluate(const Database& database, const PoseGrid& grid, const Search& search,
                            const SequenceFrames& frames, const EvalOptions& given,
                            const Progress& progress) {
  EvalOptions options = given;
  if (options.trackers.empty()) options.trackers = all_trackers(descriptor_kind(database));
  SequenceEvaluation result{.name = frames.name,
                            .kind = frames.kind,
                            .grasp_type = frames.grasp_type,
                            .truth = frames.truth,
                            .occlusion = frames.occlusion,
                            .found = means_of(frames.found)};
  std::vector<Target> truth;
  for (const FrameTruth& frame : frames.truth)
    truth.push_back(target_of(frame, frames.camera, frames.grasp_type));
  result.baselines = baselines(grid, truth, options.seed);
  count_far_grasps(result);
  const Stage stage{database,
                    grid,
                    frames,
                    options,
                    std::move(truth),
                    result.baselines,
                    std::make_shared<Describer>(database)};
  run_everything(stage, search, progress, result);
  return result;
}

Pose pose_of(const FrameTruth& truth) {
  return {truth.camera_from_hand.rotation, truth.angles, truth.joints};
}

Target target_of(const FrameTruth& truth, const Intrinsics& camera, std::optional<int> grasp_type) {
  if (truth.closure < kTypeClosure) grasp_type.reset();
  return {pose_of(truth), camera, grasp_type};
}

Answer answer_of(const Estimate& estimate, const Database& database) {
  Answer answer{{estimate.camera_from_hand.rotation, estimate.angles, estimate.joints}, {}};
  for (const Hypothesis& hypothesis : estimate.hypotheses) {
    answer.grasps[database.grasp(hypothesis.row)] += hypothesis.weight;
  }
  return answer;
}

std::vector<TrackerOptions> all_trackers(DescriptorKind kind) {
  std::vector<TrackerOptions> trackers;
  for (const TemporalModel model : kTemporalModels) trackers.push_back(tuned_options(model, kind));
  return trackers;
}

}  // namespace graspdb
