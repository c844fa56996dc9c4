// SPDX-License-Identifier: MIT
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/grasps/grasp.h"

namespace graspdb {
namespace {

// A stretch of the way that one quantity goes evenly.
template <typename Value>
struct Stretch {
  double begin, end;  // progress
  Value from, to;

  // Shortens it by a place that is passed on the way.
  void pass(double place, const Value& value, double progress) {
    if (place <= progress) {
      begin = place, from = value;
    } else if (place < end) {
      end = place, to = value;
    }
  }
  double share(double progress) const { return (progress - begin) / (end - begin); }
};

double angle_at(const Grasp& grasp, int angle, double rest, double closed, double progress) {
  Stretch<double> stretch{0, 1, rest, closed};
  for (const Waypoint& point : grasp.waypoints) {
    if (std::isnan(point.angles[angle])) continue;
    stretch.pass(point.progress, point.angles[angle], progress);
  }
  return stretch.from + stretch.share(progress) * (stretch.to - stretch.from);
}

Eigen::Vector3d approach_at(const Grasp& grasp, double progress) {
  Stretch<Eigen::Vector3d> stretch{0, 1, grasp.approach, Eigen::Vector3d::Zero()};
  for (const Waypoint& point : grasp.waypoints) {
    if (point.approach) stretch.pass(point.progress, *point.approach, progress);
  }
  const double share = stretch.share(progress);
  return (1 - share) * stretch.from + share * stretch.to;
}

}  // namespace

GraspPose pose_at_step(const Grasp& grasp, const JointAngles& rest, const GraspPose& closed,
                       int step, int steps) {
  GRASPDB_CHECK(step >= 0 && step <= steps && steps > 0);
  if (step == steps) return closed;
  const double progress = static_cast<double>(step) / steps;
  GraspPose pose = closed;
  for (int i = 0; i < kAngleCount; ++i) {
    pose.angles[i] = angle_at(grasp, i, rest[i], closed.angles[i], progress);
  }
  pose.hand_from_object.translation += approach_at(grasp, progress);
  return pose;
}

}  // namespace graspdb
