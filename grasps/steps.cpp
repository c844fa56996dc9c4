// SPDX-License-Identifier: MIT
#include "graspdb/error.h"
#include "graspdb/grasp.h"

namespace graspdb {

GraspPose pose_at_step(const Grasp& grasp, const JointAngles& rest, const GraspPose& closed,
                       int step, int steps) {
  GRASPDB_CHECK(step >= 0 && step <= steps && steps > 0);
  if (step == steps) return closed;
  const double progress = static_cast<double>(step) / steps;
  GraspPose pose = closed;
  pose.angles = rest + progress * (closed.angles - rest);
  pose.hand_from_object.translation += (1 - progress) * grasp.approach;
  return pose;
}

}  // namespace graspdb
