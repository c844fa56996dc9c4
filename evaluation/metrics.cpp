// SPDX-License-Identifier: MIT
#include "graspdb/metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "graspdb/pose_vector.h"
#include "graspdb/transform.h"

namespace graspdb {
namespace {

double mean_of(const std::vector<FrameErrors>& frames, double FrameErrors::*metric) {
  double sum = 0;
  for (const FrameErrors& frame : frames) sum += frame.*metric;
  return sum / static_cast<double>(frames.size());
}

double mean_distance_mm(const Keypoints& a, const Keypoints& b) {
  return 1000 * (a - b).colwise().norm().mean();
}

}  // namespace

double mean_joint_difference_deg(const JointAngles& a, const JointAngles& b) {
  constexpr int kFirst = kThumbCmcFlexion;  // the wrist is no finger
  return degrees((a - b).tail<kAngleCount - kFirst>().cwiseAbs().mean());
}

double mpjpe_mm(const Keypoints& a, const Keypoints& b) {
  return mean_distance_mm(a.colwise() - a.col(0), b.colwise() - b.col(0));
}

double pa_mpjpe_mm(const Keypoints& a, const Keypoints& b) {
  const Eigen::Matrix4d b_from_a = Eigen::umeyama(a, b, true);
  return mean_distance_mm(
      (b_from_a.topLeftCorner<3, 3>() * a).colwise() + b_from_a.topRightCorner<3, 1>().eval(), b);
}

FrameErrors compare(const Pose& estimate, const Pose& truth) {
  return {(pose_vector(estimate.camera_from_hand, estimate.angles) -
           pose_vector(truth.camera_from_hand, truth.angles))
              .norm(),
          degrees(angle_between(estimate.camera_from_hand, truth.camera_from_hand)),
          mean_joint_difference_deg(estimate.angles, truth.angles),
          mpjpe_mm(estimate.joints, truth.joints), pa_mpjpe_mm(estimate.joints, truth.joints)};
}

Spread spread(std::vector<double> values) {
  if (values.empty()) return {std::nan(""), std::nan(""), std::nan("")};
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (double value : values) sum += value;
  const auto quantile = [&](double q) {
    return values[static_cast<std::size_t>(
        std::lround(q * static_cast<double>(values.size() - 1)))];
  };
  return {sum / static_cast<double>(values.size()), quantile(0.5), quantile(0.9)};
}

Summary summarize(const std::vector<FrameErrors>& frames) {
  std::vector<double> rotations;
  rotations.reserve(frames.size());
  for (const FrameErrors& frame : frames) rotations.push_back(frame.rotation_deg);
  const auto flipped =
      std::count_if(rotations.begin(), rotations.end(), [](double r) { return r > 90; });
  return {mean_of(frames, &FrameErrors::pose),
          spread(rotations),
          mean_of(frames, &FrameErrors::joint_deg),
          mean_of(frames, &FrameErrors::mpjpe_mm),
          mean_of(frames, &FrameErrors::pa_mpjpe_mm),
          static_cast<double>(flipped) / static_cast<double>(frames.size())};
}

}  // namespace graspdb
