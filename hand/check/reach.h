// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// What the digits can touch: the thumb's pulp each finger's, the fingertips the palm.
std::vector<HandCheckLine> check_reach(const Hand& hand);

}  // namespace graspdb
