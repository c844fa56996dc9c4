// SPDX-License-Identifier: MIT
// How far an estimated pose is from the true one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "graspdb/angles.h"
#include "graspdb/skeleton.h"

namespace graspdb {

struct FrameErrors {
  double pose = 0;          // the paper's: Euclidean norm of the difference of pose vectors
  double rotation_deg = 0;  // geodesic
  double joint_deg = 0;     // mean absolute difference of the 26 angles of fingers and thumb
  double mpjpe_mm = 0;      // mean distance of the 21 joints, wrists put together
  double pa_mpjpe_mm = 0;   // the same after the best similarity transform
};

// A pose without a place.
struct Pose {
  Eigen::Matrix3d camera_from_hand;
  JointAngles angles;
  Keypoints joints;  // camera frame or any shift of it, metres
};

FrameErrors compare(const Pose& estimate, const Pose& truth);

double mean_joint_difference_deg(const JointAngles& a, const JointAngles& b);
double mpjpe_mm(const Keypoints& a, const Keypoints& b);     // wrists put together
double pa_mpjpe_mm(const Keypoints& a, const Keypoints& b);  // Umeyama's similarity transform

struct Spread {
  double mean = 0, median = 0, p90 = 0;
};
Spread spread(std::vector<double> values);  // all NaN for no values

struct Summary {
  double pose_error = 0;
  Spread rotation_deg;
  double joint_deg = 0;
  double mpjpe_mm = 0;
  double pa_mpjpe_mm = 0;
  double flips = 0;  // the share of frames whose rotation is off by more than 90 degrees
};
Summary summarize(const std::vector<FrameErrors>& frames);  // all NaN for no frames

}  // namespace graspdb
