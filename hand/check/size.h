// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "graspdb/hand/check/hand_check.h"

namespace graspdb {

// Length and breadth of the flat hand's skin.
std::vector<HandCheckLine> check_size(const Hand& hand, const std::optional<AskedSize>& asked);

}  // namespace graspdb
