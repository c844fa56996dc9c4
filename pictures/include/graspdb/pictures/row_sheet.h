// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "graspdb/core/image.h"
#include "graspdb/database/database.h"

namespace graspdb {

// Rows as the database's configuration renders them, below each its grasp, step, view and number.
// `first`, when it is not empty, is a square picture that stands before them under its `title`.
// Throws Error as DatabaseRows does, and when there are no rows.
ColorImage draw_row_sheet(const Database& database, std::span<const std::size_t> chosen,
                          const std::string& title, const ColorImage& first = {});

}  // namespace graspdb
