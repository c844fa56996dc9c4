// SPDX-License-Identifier: MIT
// A database is a full grid, poses x views, so that most oracles separate into the best view and
// the best pose.
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "graspdb/error.h"
#include "graspdb/evaluate.h"
#include "graspdb/parallel.h"
#include "graspdb/pose_vector.h"
#include "graspdb/random.h"

namespace graspdb {
namespace {

constexpr int kRandomRowsPerFrame = 50;

struct Grid {
  std::vector<Eigen::Matrix3d> views;  // camera_from_hand when the camera looks at the palm
  std::vector<JointAngles> poses;
  std::vector<Keypoints> joints;  // of each pose, hand frame
};

Grid read_grid(const Database& database) {
  Grid grid;
  const auto views = static_cast<std::size_t>(database.info().views);
  const std::size_t hands = database.info().hands.size();
  if (database.rows() == 0 || database.rows() % views != 0) {
    throw Error({database.path().string(), "rows", "a multiple of the views, and some",
                 std::to_string(database.rows())});
  }
  for (std::size_t view = 0; view < views; ++view) {
    grid.views.push_back(label_rotation(database.label(view)));
  }
  for (std::size_t row = 0; row < database.rows(); row += views) {
    grid.poses.push_back(label_angles(database.label(row)));
    if (database.hand(row) >= hands) {
      throw Error({database.path().string(), "hand", "a hand of the header", "an altered row"});
    }
    const Skeleton& skeleton = database.info().hands[database.hand(row)].skeleton;
    grid.joints.push_back(keypoints_in_palm(skeleton, grid.poses.back()));
  }
  return grid;
}

// The row's view, turned to where the true palm is: what the tracker would answer with this row.
Eigen::Matrix3d turned(const Eigen::Matrix3d& view, const FrameTruth& truth) {
  const Eigen::Vector3d centre = (truth.joints.col(0) + truth.joints.col(5) + truth.joints.col(9) +
                                  truth.joints.col(13) + truth.joints.col(17)) /
                                 5;
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), centre).toRotationMatrix() *
         view;
}

Pose row_pose(const Grid& grid, std::size_t pose, const Eigen::Matrix3d& camera_from_hand) {
  return {camera_from_hand, grid.poses[pose], camera_from_hand * grid.joints[pose]};
}

FrameErrors best_of_each(const Grid& grid, const FrameTruth& truth) {
  const Pose target = pose_of(truth);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  FrameErrors best{kFar, kFar, kFar, kFar, kFar};
  double sine = kFar, rotation = kFar;
  for (std::size_t p = 0; p < grid.poses.size(); ++p) {
    sine =
        std::min(sine, (grid.poses[p].array().sin() - truth.angles.array().sin()).matrix().norm());
    best.joint_deg =
        std::min(best.joint_deg, mean_joint_difference_deg(grid.poses[p], truth.angles));
    best.pa_mpjpe_mm = std::min(best.pa_mpjpe_mm, pa_mpjpe_mm(grid.joints[p], truth.joints));
  }
  for (const Eigen::Matrix3d& view : grid.views) {
    const Eigen::Matrix3d camera_from_hand = turned(view, truth);
    rotation = std::min(rotation, (camera_from_hand - truth.camera_from_hand).norm());
    best.rotation_deg = std::min(best.rotation_deg,
                                 degrees(angle_between(camera_from_hand, truth.camera_from_hand)));
    for (const Keypoints& joints : grid.joints) {
      best.mpjpe_mm = std::min(best.mpjpe_mm, mpjpe_mm(camera_from_hand * joints, target.joints));
    }
  }
  best.pose = std::hypot(sine, rotation);
  return best;
}

// The index whose summed cost over all frames is smallest.
template <typename Cost>
std::size_t cheapest(std::size_t count, const std::vector<FrameTruth>& truth, const Cost& cost) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (const FrameTruth& frame : truth) sum += cost(i, frame);
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  return best;
}

std::vector<FrameErrors> constant_errors(const Grid& grid, const std::vector<FrameTruth>& truth) {
  const std::size_t view =
      cheapest(grid.views.size(), truth, [&](std::size_t v, const FrameTruth& frame) {
        return angle_between(turned(grid.views[v], frame), frame.camera_from_hand);
      });
  const std::size_t pose =
      cheapest(grid.poses.size(), truth, [&](std::size_t p, const FrameTruth& frame) {
        return mean_joint_difference_deg(grid.poses[p], frame.angles);
      });
  std::vector<FrameErrors> errors;
  errors.reserve(truth.size());
  for (const FrameTruth& frame : truth) {
    errors.push_back(
        compare(row_pose(grid, pose, turned(grid.views[view], frame)), pose_of(frame)));
  }
  return errors;
}

std::vector<FrameErrors> random_errors(const Grid& grid, const std::vector<FrameTruth>& truth,
                                       std::uint64_t seed) {
  std::vector<FrameErrors> errors;
  for (std::size_t frame = 0; frame < truth.size(); ++frame) {
    RandomStream random(seed, frame);
    for (int i = 0; i < kRandomRowsPerFrame; ++i) {
      const auto pose = static_cast<std::size_t>(random.below(grid.poses.size()));
      const auto view = static_cast<std::size_t>(random.below(grid.views.size()));
      errors.push_back(compare(row_pose(grid, pose, turned(grid.views[view], truth[frame])),
                               pose_of(truth[frame])));
    }
  }
  return errors;
}

}  // namespace

Baselines baselines(const Database& database, const std::vector<FrameTruth>& truth,
                    std::uint64_t seed) {
  const Grid grid = read_grid(database);
  std::vector<FrameErrors> best(truth.size());
  parallel_for(truth.size(), 0, [&](std::size_t i) { best[i] = best_of_each(grid, truth[i]); });
  std::vector<double> nearest;
  nearest.reserve(best.size());
  for (const FrameErrors& frame : best) nearest.push_back(frame.joint_deg);
  const auto beyond =
      std::count_if(nearest.begin(), nearest.end(), [](double d) { return d >= 5; });
  return {
      summarize(best), summarize(random_errors(grid, truth, seed)),
      summarize(constant_errors(grid, truth)), spread(nearest),
      static_cast<double>(beyond) / static_cast<double>(std::max<std::size_t>(1, nearest.size()))};
}

}  // namespace graspdb
