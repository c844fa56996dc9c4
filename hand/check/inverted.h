// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// Triangles that bending turns inside out.
std::vector<HandCheckLine> check_inverted(const Hand& hand);

}  // namespace graspdb
