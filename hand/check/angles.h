// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// Whether each angle moves what it should, and the right way.
std::vector<HandCheckLine> check_angles(const Hand& hand);

}  // namespace graspdb
