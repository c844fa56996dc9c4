// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// What bending does to the skin: volume change, the PIP joints' sections.
std::vector<HandCheckLine> check_poses(const Hand& hand);

}  // namespace graspdb
