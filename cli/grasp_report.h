// SPDX-License-Identifier: MIT
// What the check of grasps found, for people and for machines.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "graspdb/closing.h"
#include "graspdb/grasp.h"
#include "graspdb/hand.h"

namespace graspdb::cli {

// One entry of `grasp check --json`.
nlohmann::json to_json(const Grasp& grasp, const Hand& hand, const GraspCheck& check);

// On stdout: a line a grasp, with what is worst of its steps; failures below it.
void print_summary(const std::vector<Grasp>& grasps, const std::vector<GraspCheck>& checks);

// On stdout: a line a step of one grasp, and what touches when it is closed.
void print_steps(const Grasp& grasp, const GraspCheck& check);

}  // namespace graspdb::cli
