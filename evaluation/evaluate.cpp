// SPDX-License-Identifier: MIT
#include "graspdb/evaluate.h"

#include <algorithm>
#include <array>

#include "graspdb/error.h"
#include "graspdb/noise.h"
#include "graspdb/parallel.h"
#include "graspdb/segmentation.h"

namespace graspdb {
namespace {

constexpr std::array<std::pair<TemporalModel, const char*>, 3> kModels = {{
    {TemporalModel::kNone, "none"},
    {TemporalModel::kGaussian, "gaussian"},
    {TemporalModel::kKde, "kde"},
}};

struct Frame {
  GrayImage gray;
  Mask hand;
  FrameTruth truth;
};

std::vector<Frame> render_all(const SequenceRenderer& sequence) {
  std::vector<Frame> frames(static_cast<std::size_t>(sequence.spec().frame_count()));
  parallel_for(frames.size(), 0, [&](std::size_t i) {
    SequenceFrame rendered = sequence.render(static_cast<int>(i));
    frames[i] = {to_gray(rendered.color), std::move(rendered.hand), rendered.truth};
  });
  return frames;
}

EvalRow track(Tracker& tracker, const std::vector<Frame>& frames, const SequenceSpec& spec,
              double alpha, std::uint64_t seed) {
  EvalRow row{.sequence = spec.name, .alpha = alpha, .smallest_box_px = spec.camera.height * 1.0};
  std::vector<FrameErrors> errors;
  std::vector<double> distances;
  Pose last{Eigen::Matrix3d::Identity(), JointAngles::Zero(), Keypoints::Zero()};
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Mask hand = isolate_hand(add_segmentation_noise(frames[i].hand, alpha, seed, i));
    const Estimate estimate = tracker.step({frames[i].gray, hand, spec.camera});
    if (estimate.box.height > 0) {
      row.smallest_box_px = std::min<double>(row.smallest_box_px, estimate.box.height);
      distances.push_back(estimate.distance);
    }
    // A frame without an answer is not left out, or refusing the hard ones would pay: the last
    // answer (at first a flat hand without a turn) stands for it.
    if (estimate.valid) last = pose_of(estimate);
    row.valid += estimate.valid ? 1.0 / static_cast<double>(frames.size()) : 0;
    errors.push_back(compare(last, pose_of(frames[i].truth)));
  }
  row.errors = summarize(errors);
  row.median_distance = spread(distances).median;
  return row;
}

}  // namespace

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

Pose pose_of(const FrameTruth& truth) {
  return {truth.camera_from_hand, truth.angles, truth.joints};
}

Pose pose_of(const Estimate& estimate) {
  return {estimate.camera_from_hand, estimate.angles, estimate.joints};
}

SequenceEvaluation evaluate(const Database& database, const Search& search,
                            const SequenceRenderer& sequence, const EvalOptions& options,
                            const Progress& progress) {
  const std::vector<Frame> frames = render_all(sequence);
  std::vector<FrameTruth> truth;
  truth.reserve(frames.size());
  for (const Frame& frame : frames) truth.push_back(frame.truth);
  SequenceEvaluation result{.baselines = baselines(database, truth, options.seed)};
  const std::size_t total = options.temporal.size() * options.alphas.size();
  for (TemporalModel model : options.temporal) {
    TrackerOptions settings = options.tracker;
    settings.temporal = model;
    for (double alpha : options.alphas) {
      Tracker tracker(database, search, settings);
      result.rows.push_back(track(tracker, frames, sequence.spec(), alpha, options.seed));
      result.rows.back().temporal = model;
      if (progress) progress(result.rows.size(), total);
    }
  }
  return result;
}

}  // namespace graspdb
