// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "graspdb/core/descriptor.h"
#include "graspdb/database/database.h"

namespace graspdb {

// Descriptors of the first hand of the database's configuration, in its grasps, between its steps
// and seen from anywhere: what is like its rows and is none of them. A pure function of database
// and count. Throws Error when hand or grasp files are absent or have changed since.
std::vector<DescriptorBytes> held_out_queries(const Database& database, int count);

}  // namespace graspdb
