// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graspdb/database/search.h"

namespace graspdb {

// The k nearest of descriptors that lie one behind the other: exact search without its copy, for
// the searches that fall back on it.
std::vector<Neighbor> exact_nearest(const DescriptorTable& rows, DescriptorView query, int k);

}  // namespace graspdb
