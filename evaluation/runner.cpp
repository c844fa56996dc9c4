// SPDX-License-Identifier: MIT
#include "runner.h"

#include <algorithm>

namespace graspdb {
namespace {

Answer flat_hand(const Database& database) {
  const JointAngles angles = JointAngles::Zero();
  Keypoints joints = keypoints_in_hand(database.info().hands.front().skeleton, angles);
  joints.row(2).array() += database.info().camera_distance;
  return {{Eigen::Matrix3d::Identity(), angles, joints}, {}};
}

double joint_distance_mm(const Pose& a, const Pose& b) {
  return mpjpe_mm(a.joints, b.joints);
}

template <typename Value>
std::vector<Value> collect(const std::vector<FrameResult>& frames, Value FrameResult::*member) {
  std::vector<Value> values;
  values.reserve(frames.size());
  for (const FrameResult& frame : frames) values.push_back(frame.*member);
  return values;
}

std::vector<Keypoints> true_joints(const std::vector<Target>& truth) {
  std::vector<Keypoints> joints;
  joints.reserve(truth.size());
  for (const Target& frame : truth) joints.push_back(frame.pose.joints);
  return joints;
}

}  // namespace

Runner::Runner(const Stage& stage, const Search& search, const TrackerOptions& tracker)
    : stage_(stage),
      model_(tracker.temporal),
      reader_(stage.database, search, {.tracker = tracker}, stage.describer),
      last_answer_(flat_hand(stage.database)) {}

void Runner::step(const Observation& seen) {
  const std::size_t i = frames_.size();
  const Estimate estimate = reader_.read(seen);
  if (estimate.valid) last_answer_ = answer_of(estimate, stage_.database);
  frames_.push_back({.valid = estimate.valid,
                     .confidence = estimate.confidence,
                     .distance = estimate.distance,
                     .box_height_px = estimate.box.height,
                     .row = estimate.row,
                     .grasp = estimate.grasp,
                     .errors = compare(last_answer_, stage_.truth[i])});
  split_gaps(frames_.back(), estimate.hypotheses);
  joints_.push_back(last_answer_.pose.joints);
}

void Runner::split_gaps(FrameResult& result, const std::vector<Hypothesis>& hypotheses) const {
  std::span<const Hypothesis> retrieved;
  if (result.valid) retrieved = hypotheses;
  const std::size_t i = frames_.size() - 1;
  const FrameOracle& oracle = stage_.baselines.oracle[i];
  const Pose& truth = stage_.truth[i].pose;
  result.pose_error_gap = split_gap(
      {stage_.grid, truth, last_answer_.pose, retrieved, oracle.best_pose_error}, pose_error);
  result.mpjpe_gap = split_gap(
      {stage_.grid, truth, last_answer_.pose, retrieved, oracle.best_mpjpe}, joint_distance_mm);
}

EvalRun Runner::run(double alpha) const {
  EvalRun run{.temporal = model_, .alpha = alpha, .frames = frames_};
  run.errors = summarize(collect(frames_, &FrameResult::errors));
  run.errors.mean[kUnsteadinessMm] = unsteadiness_mm(joints_, true_joints(stage_.truth));
  run.pose_error_gap = mean_gap(collect(frames_, &FrameResult::pose_error_gap));
  run.mpjpe_gap = mean_gap(collect(frames_, &FrameResult::mpjpe_gap));
  run.smallest_box_px = stage_.frames.camera.height;
  std::vector<double> distances;
  for (const FrameResult& frame : frames_) {
    run.valid += frame.valid ? 1 : 0;
    if (frame.box_height_px == 0) continue;
    run.smallest_box_px = std::min<double>(run.smallest_box_px, frame.box_height_px);
    distances.push_back(frame.distance);
  }
  run.valid /= static_cast<double>(frames_.size());
  run.median_distance = spread(distances).median;
  return run;
}

}  // namespace graspdb
