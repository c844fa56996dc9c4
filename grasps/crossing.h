// SPDX-License-Identifier: MIT
// Skin on the wrong side of a thin object, where no depth shows it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// Whether the straight way between two points outside a solid goes in at one side of it and out at
// the other one. Ways that only cut a corner or a round do not.
bool passes_through(const Solid& solid, const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// By digit, metres; 0 where nothing has crossed.
using CrossingDepths = std::array<double, kPalmAndDigitCount>;

// How far skin stands out of the object while the bone under it is on the other side. `skin` is the
// posed hand's, `digit` says whose each vertex is.
CrossingDepths crossed_skin(const Grasp& grasp, const Hand& hand, const GraspPose& pose,
                            const Mesh& skin, const std::vector<int>& digit);

// How far beyond the object skin is that has passed through it since step - 1.
CrossingDepths crossed_on_the_way(const Grasp& grasp, const Hand& hand, const JointAngles& rest,
                                  const GraspPose& closed, int step, const std::vector<int>& digit);

}  // namespace graspdb
