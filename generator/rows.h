// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "graspdb/database.h"
#include "plan.h"

namespace graspdb {

// Renders and describes all views of one step of a shard: rows[i] becomes view i, as a row of a
// database of the shard alone (hand 0, variant 0). Pure and thread-safe.
void make_rows(const Plan& plan, const Shard& shard, int step, std::span<Row> rows);

}  // namespace graspdb
