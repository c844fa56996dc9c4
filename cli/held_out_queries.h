// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/database.h"

namespace graspdb::cli {

// Descriptors of the database's own grasps halfway between its steps, seen from random orientations
// that are none of its views. Needs the hand and grasp files that it was built from.
std::vector<Descriptor> held_out_queries(const Database& database, int count);

}  // namespace graspdb::cli
