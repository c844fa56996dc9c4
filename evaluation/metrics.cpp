// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/metrics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/tracker/pose_vector.h"
#include "nan.h"

namespace graspdb {
namespace {

constexpr int kWrist = 0, kMiddleMcp = 9;

constexpr std::array<MetricInfo, kRunMetricCount> kMetrics = {{
    {"pose_error", ""},
    {"rotation_deg", "deg"},
    {"flips", ""},
    {"joint_deg", "deg"},
    {"mcp_deg", "deg"},
    {"pip_deg", "deg"},
    {"dip_deg", "deg"},
    {"thumb_deg", "deg"},
    {"mpjpe_mm", "mm"},
    {"sn_mpjpe_mm", "mm"},
    {"pa_mpjpe_mm", "mm"},
    {"error_2d_palms", "palms"},
    {"grasp_top1", "", true},
    {"grasp_top5", "", true},
    {"grasp17_top1", "", true},
    {"grasp17_top5", "", true},
    {"jitter_mm", "mm/frame^2"},
}};

// The classes of more than one type.
constexpr std::array<std::array<int, 5>, 8> kMerged = {{{1, 2, 3, 10, 11},
                                                        {4, 5, 15, 30},
                                                        {6, 12, 13},
                                                        {7, 27},
                                                        {8, 14},
                                                        {9, 24, 33},
                                                        {16, 29, 32},
                                                        {18, 26}}};

double mean_distance_mm(const Keypoints& a, const Keypoints& b) {
  return 1000 * (a - b).colwise().norm().mean();
}

Keypoints from_wrist(const Keypoints& joints) {
  return joints.colwise() - joints.col(kWrist);
}

double finger_difference_deg(const JointAngles& difference, FingerAngle angle) {
  double sum = 0;
  for (int finger = 0; finger < kFingerCount; ++finger) {
    sum += std::abs(difference[finger_angle(finger, angle)]);
  }
  return degrees(sum / kFingerCount);
}

GraspWeights merged(const GraspWeights& weights) {
  GraspWeights classes;
  for (const auto& [type, weight] : weights) classes[merged_class(type)] += weight;
  return classes;
}

void compare_grasps(const GraspWeights& grasps, int type, FrameErrors& errors) {
  const GraspWeights classes = merged(grasps);
  errors[kGraspTop1] = is_among_heaviest(grasps, type, 1);
  errors[kGraspTop5] = is_among_heaviest(grasps, type, 5);
  errors[kGrasp17Top1] = is_among_heaviest(classes, merged_class(type), 1);
  errors[kGrasp17Top5] = is_among_heaviest(classes, merged_class(type), 5);
}

double mean_where_it_applies(const std::vector<FrameErrors>& frames, std::size_t metric) {
  std::vector<double> errors;
  for (const FrameErrors& frame : frames) errors.push_back(frame[metric]);
  return mean_of_numbers(errors);
}

}  // namespace

const MetricInfo& metric_info(int metric) {
  GRASPDB_CHECK(metric >= 0 && metric < kRunMetricCount);
  return kMetrics[static_cast<std::size_t>(metric)];
}

FrameErrors compare(const Answer& answer, const Target& truth) {
  FrameErrors errors;
  errors.fill(kNan);
  const Pose &estimate = answer.pose, &target = truth.pose;
  errors[kPoseError] = pose_error(estimate, target);
  errors[kRotationDeg] = rotation_deg(estimate.rotation, target.rotation);
  errors[kFlips] = errors[kRotationDeg] > 90;
  compare_angles(estimate.angles, target.angles, errors);
  errors[kMpjpeMm] = mpjpe_mm(estimate.joints, target.joints);
  errors[kSnMpjpeMm] = sn_mpjpe_mm(estimate.joints, target.joints);
  errors[kPaMpjpeMm] = pa_mpjpe_mm(estimate.joints, target.joints);
  errors[kError2dPalms] = error_2d_palms(estimate.joints, target.joints, truth.camera);
  if (truth.grasp_type) compare_grasps(answer.grasps, *truth.grasp_type, errors);
  return errors;
}

double pose_error(const Pose& a, const Pose& b) {
  return (pose_vector(a.rotation, a.angles) - pose_vector(b.rotation, b.angles)).norm();
}

double rotation_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return degrees(angle_between(a, b));
}

void compare_angles(const JointAngles& a, const JointAngles& b, FrameErrors& errors) {
  const JointAngles difference = a - b;
  constexpr int kThumbAngles = kFirstFingerAngle - kThumbCmcFlexion;
  errors[kJointDeg] = mean_joint_difference_deg(a, b);
  errors[kMcpDeg] = finger_difference_deg(difference, kMcpFlexion);
  errors[kPipDeg] = finger_difference_deg(difference, kPipFlexion);
  errors[kDipDeg] = finger_difference_deg(difference, kDipFlexion);
  errors[kThumbDeg] = degrees(difference.segment<kThumbAngles>(kThumbCmcFlexion).cwiseAbs().mean());
}

double mean_joint_difference_deg(const JointAngles& a, const JointAngles& b) {
  constexpr int kFirst = kThumbCmcFlexion;  // the wrist is no finger
  return degrees((a - b).tail<kAngleCount - kFirst>().cwiseAbs().mean());
}

double mpjpe_mm(const Keypoints& a, const Keypoints& b) {
  return mean_distance_mm(from_wrist(a), from_wrist(b));
}

double best_scale(const Keypoints& estimate, const Keypoints& truth) {
  const Keypoints from = from_wrist(estimate);
  return std::max(0.0, from.cwiseProduct(from_wrist(truth)).sum() / from.squaredNorm());
}

double sn_mpjpe_mm(const Keypoints& estimate, const Keypoints& truth) {
  return mean_distance_mm(best_scale(estimate, truth) * from_wrist(estimate), from_wrist(truth));
}

double pa_mpjpe_mm(const Keypoints& a, const Keypoints& b) {
  const Eigen::Matrix4d b_from_a = Eigen::umeyama(a, b, true);
  return mean_distance_mm(
      (b_from_a.topLeftCorner<3, 3>() * a).colwise() + b_from_a.topRightCorner<3, 1>().eval(), b);
}

double error_2d_palms(const Keypoints& estimate, const Keypoints& truth, const Intrinsics& camera) {
  const double nearest = std::min(estimate.row(2).minCoeff(), truth.row(2).minCoeff());
  if (nearest <= kNearestDepth) return kNan;
  double sum = 0;
  for (int i = 0; i < kKeypointCount; ++i) {
    sum += (camera.project(estimate.col(i)) - camera.project(truth.col(i))).norm();
  }
  const double palm = (truth.col(kMiddleMcp) - truth.col(kWrist)).norm();
  return sum / kKeypointCount / (palm * camera.fx / truth(2, kWrist));
}

int merged_class(int grasp_type) {
  for (const auto& types : kMerged) {
    if (std::find(types.begin(), types.end(), grasp_type) != types.end()) return types.front();
  }
  return grasp_type;
}

bool is_among_heaviest(const GraspWeights& weights, int type, std::size_t count) {
  const auto own = weights.find(type);
  if (own == weights.end()) return false;
  const auto before = std::count_if(weights.begin(), weights.end(), [&](const auto& other) {
    return other.second > own->second || (other.second == own->second && other.first < type);
  });
  return static_cast<std::size_t>(before) < count;
}

double unsteadiness_mm(const std::vector<Keypoints>& estimates,
                       const std::vector<Keypoints>& truth) {
  GRASPDB_CHECK(estimates.size() == truth.size());
  if (truth.size() < 3) return kNan;
  const auto off = [&](std::size_t i) -> Keypoints {
    return from_wrist(estimates[i]) - from_wrist(truth[i]);
  };
  double sum = 0;
  for (std::size_t i = 1; i + 1 < truth.size(); ++i) {
    sum += (off(i - 1) - 2 * off(i) + off(i + 1)).squaredNorm();
  }
  const double joints = kKeypointCount - 1;  // the wrists are together
  return 1000 * std::sqrt(sum / (joints * static_cast<double>(truth.size() - 2)));
}

double mean_of_numbers(const std::vector<double>& values) {
  double sum = 0, count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / count : kNan;
}

double percentile(const std::vector<double>& ascending, std::size_t percent) {
  GRASPDB_CHECK(percent >= 1 && percent <= 100);
  if (ascending.empty()) return kNan;
  const std::size_t rank = (percent * ascending.size() + 99) / 100;  // from 1
  return ascending[rank - 1];
}

Spread spread(std::vector<double> values) {
  if (values.empty()) return {kNan, kNan, kNan};
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  return {mean, percentile(values, 50), percentile(values, 90)};
}

Summary summarize(const std::vector<FrameErrors>& frames) {
  Summary summary;
  summary.mean.fill(kNan);
  for (std::size_t m = 0; m < kMetricCount; ++m) {
    summary.mean[m] = mean_where_it_applies(frames, m);
  }
  std::vector<double> rotations;
  rotations.reserve(frames.size());
  for (const FrameErrors& frame : frames) rotations.push_back(frame[kRotationDeg]);
  summary.rotation_deg = spread(std::move(rotations));
  return summary;
}

}  // namespace graspdb
