// SPDX-License-Identifier: MIT
// Pictures of grasps.
#pragma once

#include <map>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// One closed grasp from six sides, and below it the steps from rest to closed, from the thumb's
// side.
ColorImage draw_grasp_sheet(const Hand& hand, const Grasp& grasp, const JointAngles& rest,
                            const GraspPose& closed);

// One closed grasp a tile, from the two sides that tell most; with number and name unless `plain`.
// Every grasp must have its pose.
ColorImage draw_grasp_page(const Hand& hand, const std::vector<Grasp>& grasps,
                           const std::map<int, GraspPose>& closed, bool plain);

// One grasp a row: its steps from rest to closed, from the side that tells most. All pictures of a
// row have one scale. With number and name unless `plain`.
ColorImage draw_step_page(const Hand& hand, const std::vector<Grasp>& grasps,
                          const JointAngles& rest, const std::map<int, GraspPose>& closed,
                          bool plain);

}  // namespace graspdb
