// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/database.h"
#include "graspdb/image.h"

namespace graspdb::cli {

// `count` rows, evenly chosen, as the database's configuration renders them; below each its number,
// grasp, step and view. Throws Error as DatabaseRows does.
ColorImage draw_row_sheet(const Database& database, std::size_t count);

}  // namespace graspdb::cli
