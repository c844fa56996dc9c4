// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/baselines.h"

#include <limits>

#include "graspdb/core/parallel.h"
#include "graspdb/core/random.h"

namespace graspdb {
namespace {

constexpr int kRandomRowsPerFrame = 50;
constexpr int kRandomGrasps = 20;  // as many as the tracker has hypotheses

// The index whose summed cost over all frames is smallest.
template <typename Cost>
std::size_t cheapest(std::size_t count, const std::vector<Target>& truth, const Cost& cost) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (const Target& frame : truth) sum += cost(i, frame);
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  return best;
}

Summary with_unsteadiness(Summary summary, const std::vector<Keypoints>& joints,
                          const std::vector<Target>& truth) {
  std::vector<Keypoints> true_joints;
  for (const Target& frame : truth) true_joints.push_back(frame.pose.joints);
  summary.mean[kUnsteadinessMm] = unsteadiness_mm(joints, true_joints);
  return summary;
}

Summary oracle_errors(const PoseGrid& grid, const std::vector<FrameOracle>& oracle,
                      const std::vector<Target>& truth) {
  std::vector<FrameErrors> errors;
  std::vector<Keypoints> joints;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const GridPlace& best = oracle[i].best_mpjpe;
    errors.push_back(oracle[i].errors);
    joints.push_back(grid.seen(best.pose, best.view, truth[i].pose).joints);
  }
  return with_unsteadiness(summarize(errors), joints, truth);
}

Summary constant_errors(const PoseGrid& grid, const std::vector<Target>& truth) {
  const std::size_t view =
      cheapest(grid.views().size(), truth, [&](std::size_t v, const Target& frame) {
        return rotation_deg(turn_to_palm(frame.pose) * grid.views()[v], frame.pose.rotation);
      });
  const std::size_t pose =
      cheapest(grid.poses().size(), truth, [&](std::size_t p, const Target& frame) {
        return mean_joint_difference_deg(grid.poses()[p].angles, frame.pose.angles);
      });
  const GraspWeights grasp = {{grid.poses()[pose].grasp, 1}};
  std::vector<FrameErrors> errors;
  std::vector<Keypoints> joints;
  for (const Target& frame : truth) {
    const Pose seen = grid.seen(pose, view, frame.pose);
    errors.push_back(compare({seen, grasp}, frame));
    joints.push_back(seen.joints);
  }
  return with_unsteadiness(summarize(errors), joints, truth);
}

std::uint32_t random_row(const PoseGrid& grid, RandomStream& random) {
  return static_cast<std::uint32_t>(random.below(grid.rows()));
}

// Of rows drawn one after another, each a little lighter than the one before.
GraspWeights random_grasps(const PoseGrid& grid, RandomStream& random) {
  GraspWeights weights;
  for (int weight = kRandomGrasps; weight > 0; --weight) {
    weights[grid.poses()[grid.pose_of(random_row(grid, random))].grasp] += weight;
  }
  return weights;
}

Summary random_errors(const PoseGrid& grid, const std::vector<Target>& truth, std::uint64_t seed) {
  std::vector<FrameErrors> errors;
  std::vector<Keypoints> joints;
  for (std::size_t frame = 0; frame < truth.size(); ++frame) {
    RandomStream random(seed, frame);
    for (int i = 0; i < kRandomRowsPerFrame; ++i) {
      const std::uint32_t row = random_row(grid, random);
      const Pose seen = grid.seen(grid.pose_of(row), grid.view_of(row), truth[frame].pose);
      errors.push_back(compare({seen, random_grasps(grid, random)}, truth[frame]));
      if (i == 0) joints.push_back(seen.joints);
    }
  }
  return with_unsteadiness(summarize(errors), joints, truth);
}

}  // namespace

Baselines baselines(const PoseGrid& grid, const std::vector<Target>& truth, std::uint64_t seed) {
  Baselines result;
  result.oracle.resize(truth.size());
  parallel_for(truth.size(), 0, [&](std::size_t i) { result.oracle[i] = oracle(grid, truth[i]); });
  result.oracle_mean = oracle_errors(grid, result.oracle, truth);
  result.random = random_errors(grid, truth, seed);
  result.constant = constant_errors(grid, truth);
  return result;
}

}  // namespace graspdb
