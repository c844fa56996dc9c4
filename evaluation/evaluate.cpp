// SPDX-License-Identifier: MIT
#include "graspdb/evaluate.h"

#include <algorithm>
#include <array>
#include <mutex>

#include "graspdb/error.h"
#include "graspdb/noise.h"
#include "graspdb/parallel.h"
#include "graspdb/segmentation.h"
#include "runner.h"

namespace graspdb {
namespace {

constexpr std::array<std::pair<TemporalModel, const char*>, 3> kModels = {{
    {TemporalModel::kNone, "none"},
    {TemporalModel::kGaussian, "gaussian"},
    {TemporalModel::kKde, "kde"},
}};

// The models look the same frame up one after another: only the first one searches. Not
// thread-safe.
class LastSearch : public Search {
 public:
  explicit LastSearch(const Search& search) : search_(search) {}
  std::vector<Neighbor> nearest(const Descriptor& query, int k) const override {
    if (k != k_ || query != query_) {
      found_ = search_.nearest(query, k);
      query_ = query;
      k_ = k;
    }
    return found_;
  }

 private:
  const Search& search_;
  mutable Descriptor query_{};
  mutable int k_ = -1;
  mutable std::vector<Neighbor> found_;
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
  for (const TemporalModel model : stage.options.temporal) all.emplace_back(stage, search, model);
  return all;
}

// A run of each temporal model, side by side.
std::vector<EvalRun> run_all(const Stage& stage, const Search& search, double alpha) {
  const LastSearch last(search);
  std::vector<Runner> models = runners(stage, last);
  for (std::size_t i = 0; i < stage.frames.hand.size(); ++i) {
    const Mask hand =
        isolate_hand(add_segmentation_noise(stage.frames.hand[i], alpha, stage.options.seed, i));
    for (Runner& model : models) model.step(hand);
  }
  std::vector<EvalRun> runs;
  for (const Runner& model : models) runs.push_back(model.run(alpha));
  return runs;
}

std::vector<Recovery> recover(const Stage& stage, const Search& search) {
  const std::size_t count = stage.frames.hand.size();
  if (count <= kBlackFrames) return {};
  const std::size_t black = (count - kBlackFrames) / 2, seen_again = black + kBlackFrames;
  const LastSearch last(search);
  std::vector<Runner> models = runners(stage, last);
  std::vector<Recovery> recoveries;
  for (const TemporalModel model : stage.options.temporal) recoveries.push_back({model, 0, false});
  const Mask nothing(stage.frames.camera.width, stage.frames.camera.height);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_black = i >= black && i < seen_again;
    const Mask hand = is_black ? nothing : isolate_hand(stage.frames.hand[i]);
    for (std::size_t m = 0; m < models.size(); ++m) {
      const FrameResult& frame = models[m].step(hand);
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
  const std::size_t models = stage.options.temporal.size(), tasks = alphas.size() + 1;
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

}  // namespace

SequenceFrames render_frames(const SequenceRenderer& sequence) {
  const SequenceSpec& spec = sequence.spec();
  const auto count = static_cast<std::size_t>(spec.frame_count());
  SequenceFrames frames{.name = spec.name, .grasp_type = spec.grasp_type, .camera = spec.camera};
  frames.gray.resize(count);
  frames.hand.resize(count);
  frames.truth.resize(count);
  frames.occlusion.resize(count);
  parallel_for(count, 0, [&](std::size_t i) {
    SequenceFrame rendered = sequence.render(static_cast<int>(i));
    frames.gray[i] = to_gray(rendered.color);
    frames.hand[i] = std::move(rendered.hand);
    frames.truth[i] = rendered.truth;
    frames.occlusion[i] = rendered.occlusion;
  });
  return frames;
}

SequenceEvaluation evaluate(const Database& database, const PoseGrid& grid, const Search& search,
                            const SequenceFrames& frames, const EvalOptions& options,
                            const Progress& progress) {
  SequenceEvaluation result{.name = frames.name,
                            .grasp_type = frames.grasp_type,
                            .truth = frames.truth,
                            .occlusion = frames.occlusion};
  std::vector<Target> truth;
  for (const FrameTruth& frame : frames.truth)
    truth.push_back(target_of(frame, frames.camera, frames.grasp_type));
  result.baselines = baselines(grid, truth, options.seed);
  count_far_grasps(result);
  const Stage stage{database, grid, frames, options, std::move(truth), result.baselines};
  run_everything(stage, search, progress, result);
  return result;
}

Pose pose_of(const FrameTruth& truth) {
  return {truth.camera_from_hand, truth.angles, truth.joints};
}

Target target_of(const FrameTruth& truth, const Intrinsics& camera, std::optional<int> grasp_type) {
  if (truth.closure < kTypeClosure) grasp_type.reset();
  return {pose_of(truth), camera, grasp_type};
}

Answer answer_of(const Estimate& estimate, const Database& database) {
  Answer answer{{estimate.camera_from_hand, estimate.angles, estimate.joints}, {}};
  for (const Hypothesis& hypothesis : estimate.hypotheses) {
    answer.grasps[database.grasp(hypothesis.row)] += hypothesis.weight;
  }
  return answer;
}

std::string temporal_name(TemporalModel model) {
  const auto found =
      std::find_if(kModels.begin(), kModels.end(), [&](const auto& m) { return m.first == model; });
  GRASPDB_CHECK(found != kModels.end());
  return found->second;
}

TemporalModel temporal_from_name(const std::string& name) {
  for (const auto& [model, known] : kModels) {
    if (name == known) return model;
  }
  throw Error({.key = "temporal", .expected = "none, gaussian or kde", .found = name});
}

}  // namespace graspdb
