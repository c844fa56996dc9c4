// SPDX-License-Identifier: MIT
// What the check of grasps found, for people and for machines.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// One entry of `grasp check --json`.
nlohmann::json check_json(const Grasp& grasp, const Hand& hand, const GraspCheck& check);

// One line per grasp, with what is worst of its steps; failures below it.
std::string summary_table(const std::vector<Grasp>& grasps, const std::vector<GraspCheck>& checks);

// One line per step of one grasp, and what touches when it is closed.
std::string step_table(const Grasp& grasp, const GraspCheck& check);

}  // namespace graspdb
