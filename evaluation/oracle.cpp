// SPDX-License-Identifier: MIT
// Most metrics separate into the best view and the best pose. Three do not: all pairs are compared
// joint by joint, those with the longest levers first, and a pair is left as soon as it is worse
// than the best one so far or a bound says that it will be.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "graspdb/core/transform.h"
#include "graspdb/evaluation/baselines.h"
#include "graspdb/tracker/pose_vector.h"
#include "nan.h"

namespace graspdb {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kMovingJoints = kKeypointCount - 1;
constexpr std::array<int, kKeypointCount> kTipsFirst = {12, 4,  20, 8,  16, 11, 3,  19, 7,  15, 10,
                                                        2,  18, 6,  14, 9,  1,  17, 5,  13, 0};

struct Best {
  double error = kFar;
  GridPlace place;
};

// One true frame before the grid.
class Comparison {
 public:
  Comparison(const PoseGrid& grid, const Target& truth)
      : grid_(grid),
        truth_(truth),
        turn_(turn_to_palm(truth.pose)),
        true_joints_(truth.pose.rotation.transpose() *
                     (truth.pose.joints.colwise() - truth.pose.joints.col(0))) {
    order_views();
    for (const Keypoints& joints : seen_from_) look_from(joints);
    for (const auto& pose : grid.poses()) measure_pose(pose.joints);
  }

  FrameOracle best() {
    FrameOracle result;
    result.errors.fill(kNan);
    best_angles(result);
    best_rotation(result);
    const Best mpjpe = best_mpjpe(), scaled = best_scaled(), flat = best_2d();
    result.best_mpjpe = mpjpe.place;
    result.errors[kMpjpeMm] = 1000 * mpjpe.error / kKeypointCount;
    result.errors[kSnMpjpeMm] = 1000 * scaled.error / kKeypointCount;
    const Keypoints& joints = truth_.pose.joints;
    const double palm_px = (joints.col(9) - joints.col(0)).norm() * truth_.camera.fx / joints(2, 0);
    const double error = flat.error / kKeypointCount / palm_px;
    result.errors[kError2dPalms] = std::isfinite(error) ? error : kNan;
    best_grasp(result.errors);
    return result;
  }

 private:
  // Views nearest to the truth first, so that good rows are found early.
  void order_views() {
    std::vector<double> turn(grid_.views().size());
    for (std::size_t v = 0; v < turn.size(); ++v) {
      turn[v] = rotation_deg(turn_ * grid_.views()[v], truth_.pose.rotation);
    }
    order_.resize(turn.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return turn[a] < turn[b]; });
    for (const std::size_t v : order_) {
      rotations_.push_back(turn_ * grid_.views()[v]);
      seen_from_.push_back(rotations_.back().transpose() * truth_.pose.rotation * true_joints_);
    }
    nearest_turn_ = turn[order_.front()];
  }

  // How far the true joints are, as this view sees them, from the true joints as they are; and from
  // the rays from the wrist through these, for hands of any size.
  void look_from(const Keypoints& seen) {
    double off = 0, off_ray = 0;
    for (int i = 1; i < kKeypointCount; ++i) {
      off += (seen.col(i) - true_joints_.col(i)).norm();
      const double square = true_joints_.col(i).squaredNorm();
      const double along = std::max(0.0, seen.col(i).dot(true_joints_.col(i)));
      off_ray += std::sqrt(std::max(0.0, square - along * along / square));
    }
    view_off_.push_back(off);
    view_off_ray_.push_back(off_ray);
  }

  void measure_pose(const Keypoints& joints) {
    double off = 0, reach = 0;
    for (int i = 1; i < kKeypointCount; ++i) {
      off += (joints.col(i) - true_joints_.col(i)).norm();
      reach += joints.col(i).norm() * true_joints_.col(i).norm();
    }
    pose_off_.push_back(off);
    square_.push_back(joints.squaredNorm());
    largest_scale_.push_back(reach / square_.back());
  }

  void best_angles(FrameOracle& result) const {
    double sine = kFar;
    FrameErrors errors = result.errors;
    for (int m = kJointDeg; m <= kThumbDeg; ++m) result.errors[static_cast<std::size_t>(m)] = kFar;
    result.errors[kPaMpjpeMm] = kFar;
    for (std::size_t p = 0; p < grid_.poses().size(); ++p) {
      const auto& pose = grid_.poses()[p];
      compare_angles(pose.angles, truth_.pose.angles, errors);
      errors[kPaMpjpeMm] = pa_mpjpe_mm(pose.joints, true_joints_);
      for (std::size_t m = 0; m < kMetricCount; ++m) {
        if (errors[m] < result.errors[m]) result.errors[m] = errors[m];
      }
      const double off =
          (pose.angles.array().sin() - truth_.pose.angles.array().sin()).matrix().norm();
      if (off < sine) {
        sine = off;
        result.best_pose_error.pose = p;
      }
    }
    result.errors[kPoseError] = sine;  // of the angles so far
  }

  void best_rotation(FrameOracle& result) const {
    // The norm of the difference of two rotation matrices grows with the angle between them.
    const double off = (rotations_.front() - truth_.pose.rotation).norm();
    result.best_pose_error.view = order_.front();
    result.errors[kPoseError] = std::hypot(result.errors[kPoseError], off);
    result.errors[kRotationDeg] = nearest_turn_;
    result.errors[kFlips] = nearest_turn_ > 90;
  }

  // Sum over the joints, metres.
  Best best_mpjpe() const {
    const auto bound = [this](std::size_t v, std::size_t p) {
      return std::abs(view_off_[v] - pose_off_[p]);
    };
    return best_pair(bound, [this](std::size_t v, std::size_t p, double limit) {
      const Keypoints& joints = grid_.poses()[p].joints;
      return sum_until(limit, kMovingJoints,
                       [&](int i) { return (seen_from_[v].col(i) - joints.col(i)).norm(); });
    });
  }

  Best best_scaled() const {
    const auto bound = [this](std::size_t v, std::size_t p) {
      return view_off_ray_[v] - largest_scale_[p] * pose_off_[p];
    };
    return best_pair(bound, [this](std::size_t v, std::size_t p, double limit) {
      const Keypoints& joints = grid_.poses()[p].joints;
      const double scale = std::max(0.0, joints.cwiseProduct(seen_from_[v]).sum() / square_[p]);
      return sum_until(limit, kMovingJoints, [&](int i) {
        return (seen_from_[v].col(i) - scale * joints.col(i)).norm();
      });
    });
  }

  // Sum over the joints, pixels.
  Best best_2d() const {
    const Keypoints& joints = truth_.pose.joints;
    if (joints.row(2).minCoeff() <= kNearestDepth) return {};
    Eigen::Matrix<double, 2, kKeypointCount> target;
    for (int i = 0; i < kKeypointCount; ++i) target.col(i) = truth_.camera.project(joints.col(i));
    std::vector<Keypoints> from_palm;
    for (const auto& pose : grid_.poses())
      from_palm.push_back(pose.joints.colwise() - palm_center(pose.joints));
    const Eigen::Vector3d palm = palm_center(joints);
    const auto no_bound = [](std::size_t, std::size_t) { return 0.0; };
    return best_pair(no_bound, [&](std::size_t v, std::size_t p, double limit) {
      return sum_until(limit, kKeypointCount, [&](int i) {
        const Eigen::Vector3d joint = rotations_[v] * from_palm[p].col(i) + palm;
        if (joint.z() <= kNearestDepth) return kFar;
        return (truth_.camera.project(joint) - target.col(i)).norm();
      });
    });
  }

  // `cost` may stop and return anything not below `limit` once it knows that it will reach it.
  template <typename Bound, typename Cost>
  Best best_pair(const Bound& bound, const Cost& cost) const {
    Best best;
    for (std::size_t v = 0; v < order_.size(); ++v) {
      for (std::size_t p = 0; p < grid_.poses().size(); ++p) {
        if (bound(v, p) >= best.error) continue;
        const double error = cost(v, p, best.error);
        if (error < best.error) best = {error, {p, order_[v]}};
      }
    }
    return best;
  }

  template <typename Distance>
  static double sum_until(double limit, int count, const Distance& distance) {
    double sum = 0;
    for (int i = 0; i < count && sum < limit; ++i)
      sum += distance(kTipsFirst[static_cast<std::size_t>(i)]);
    return sum;
  }

  void best_grasp(FrameErrors& errors) const {
    if (!truth_.grasp_type) return;
    const int type = *truth_.grasp_type;
    const auto& poses = grid_.poses();
    const bool found = std::any_of(poses.begin(), poses.end(),
                                   [type](const auto& pose) { return pose.grasp == type; });
    const bool class_found = std::any_of(poses.begin(), poses.end(), [type](const auto& pose) {
      return merged_class(pose.grasp) == merged_class(type);
    });
    errors[kGraspTop1] = errors[kGraspTop5] = found;
    errors[kGrasp17Top1] = errors[kGrasp17Top5] = class_found;
  }

  const PoseGrid& grid_;
  const Target& truth_;
  Eigen::Matrix3d turn_;
  Keypoints true_joints_;  // hand frame, as those of the poses: all wrists at the origin

  // In the order of the views' distance from the truth.
  std::vector<std::size_t> order_;
  std::vector<Eigen::Matrix3d> rotations_;
  std::vector<Keypoints> seen_from_;  // the true joints in the hand frame that the view states
  std::vector<double> view_off_, view_off_ray_;
  double nearest_turn_ = 0;

  std::vector<double> pose_off_, square_, largest_scale_;  // a pose each
};

}  // namespace

FrameOracle oracle(const PoseGrid& grid, const Target& truth) {
  return Comparison(grid, truth).best();
}

}  // namespace graspdb
