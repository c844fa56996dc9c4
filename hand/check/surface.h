// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// Open and turned edges, pinched vertices, Euler number, volume, quality and length of edges.
std::vector<HandCheckLine> check_surface(const Hand& hand);

}  // namespace graspdb
