// SPDX-License-Identifier: MIT
// How far an estimated pose is from the true one: a table of metrics, so that baselines, means,
// intervals and files treat all of them alike. docs/evaluation.md defines each.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/hand/angles.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

enum Metric {
  kPoseError,     // the paper's: Euclidean norm of the difference of pose vectors
  kRotationDeg,   // geodesic
  kFlips,         // 1 when the rotation is off by more than 90 degrees
  kJointDeg,      // mean absolute difference of the 26 angles of fingers and thumb
  kMcpDeg,        // ... of the four fingers' MCP flexion
  kPipDeg,        //
  kDipDeg,        //
  kThumbDeg,      // ... of the thumb's six angles
  kMpjpeMm,       // mean distance of the 21 joints, wrists put together
  kSnMpjpeMm,     // ... after the estimate is scaled by the best single factor
  kPaMpjpeMm,     // ... after the best similarity transform
  kError2dPalms,  // mean distance of the projected joints over the palm's length in the picture
  kGraspTop1,     // 1 when the true type of grasp is the heaviest
  kGraspTop5,     // ... among the five heaviest
  kGrasp17Top1,   // the same on 17 merged classes
  kGrasp17Top5,   //
  kMetricCount,   // metrics of a frame
  kUnsteadinessMm = kMetricCount,  // of a run of frames: see unsteadiness_mm
  kRunMetricCount,
};

struct MetricInfo {
  std::string_view name;  // as in files, e.g. "rotation_deg"
  std::string_view unit;  // "" for the paper's error, shares and the like
  bool more_is_better = false;
};
const MetricInfo& metric_info(int metric);  // 0 <= metric < kRunMetricCount

using FrameErrors = std::array<double, kMetricCount>;   // NaN where a metric does not apply
using RunErrors = std::array<double, kRunMetricCount>;  // means over the frames where it applies

struct Pose {
  Eigen::Matrix3d rotation;  // of camera_from_hand
  JointAngles angles;
  Keypoints joints;  // camera frame, metres
};

using GraspWeights = std::map<int, double>;  // by the grasp's id

struct Answer {
  Pose pose;
  GraspWeights grasps;
};

// What an answer is held against.
struct Target {
  Pose pose;
  Intrinsics camera;
  std::optional<int> grasp_type;  // Feix's number, when the type is to be told
};

FrameErrors compare(const Answer& answer, const Target& truth);

// Single metrics, for where the others would be a waste.
double pose_error(const Pose& a, const Pose& b);
double rotation_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);
// Sets kJointDeg to kThumbDeg.
void compare_angles(const JointAngles& a, const JointAngles& b, FrameErrors& errors);
double mean_joint_difference_deg(const JointAngles& a, const JointAngles& b);  // kJointDeg
double mpjpe_mm(const Keypoints& a, const Keypoints& b);
double sn_mpjpe_mm(const Keypoints& estimate, const Keypoints& truth);
double pa_mpjpe_mm(const Keypoints& a, const Keypoints& b);  // Umeyama's similarity transform
// NaN when a joint is not in front of the camera. The palm's length is that from wrist to middle
// MCP joint, as large as the picture shows what is as far away as the wrist.
double error_2d_palms(const Keypoints& estimate, const Keypoints& truth, const Intrinsics& camera);

// The factor by which the estimate fits best (least squares), wrists together; not below 0.
double best_scale(const Keypoints& estimate, const Keypoints& truth);

// Feix's 33 types merged to the 17 that agree in type, opposition, virtual fingers and thumb
// (Feix et al., IEEE THMS 46(1), 2016): the smallest number of the class. Other ids stay.
int merged_class(int grasp_type);
// Whether `type` is one of the `count` heaviest; ties by id.
bool is_among_heaviest(const GraspWeights& weights, int type, std::size_t count);

// Root mean square over frames and joints of the second difference over time of estimate minus
// truth, wrists put together, mm a frame squared; NaN for fewer than three frames. Files call it
// jitter_mm, which has nothing to do with a database's jitter.
double unsteadiness_mm(const std::vector<Keypoints>& estimates,
                       const std::vector<Keypoints>& truth);

// The smallest of these values, smallest first, that `percent` of them or more do not exceed
// (nearest rank), 1 to 100; NaN for no values.
double percentile(const std::vector<double>& ascending, std::size_t percent);

// The mean of those that are numbers; NaN when none is.
double mean_of_numbers(const std::vector<double>& values);

struct Spread {
  double mean = 0, median = 0, p90 = 0;
};
Spread spread(std::vector<double> values);  // all NaN for no values

struct Summary {
  RunErrors mean;
  Spread rotation_deg;
};
// Over the frames where a metric applies; NaN where it applies to none. Jitter is NaN.
Summary summarize(const std::vector<FrameErrors>& frames);

}  // namespace graspdb
