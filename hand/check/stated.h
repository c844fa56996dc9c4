// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// What a rig map states, or a rule fills in, against what the skin shows.
std::vector<HandCheckLine> check_stated(const Hand& hand);

}  // namespace graspdb
