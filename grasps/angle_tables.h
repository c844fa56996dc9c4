// SPDX-License-Identifier: MIT
// Joint angles as people write them: a table a digit, degrees.
#pragma once

#include <string>

#include "graspdb/core/toml.h"
#include "graspdb/hand/angles.h"

namespace graspdb {

// Reads wrist_deg, thumb_deg, index_deg, ... little_deg; every angle within its range. What is not
// stated is `otherwise`. Throws Error.
JointAngles read_angles(const TomlTable& table, double otherwise = 0);

// The same tables as text, a line a digit; to 1e-6 degrees.
std::string write_angles(const JointAngles& angles);

}  // namespace graspdb
