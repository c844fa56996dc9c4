// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

#include "graspdb/database/database.h"
#include "header.h"

namespace graspdb {

using ByteSink = std::function<void(std::span<const std::byte>)>;

// Hands the bytes of one column, in pieces, to the sink; the same bytes whenever it is called.
using ColumnSource = std::function<void(ColumnIndex, const ByteSink&)>;

// Writes a database file aside and renames it. The source is asked for every column twice, for its
// hash and for the file, so that none needs to be held whole.
void write_columns(const std::filesystem::path& path, const DatabaseInfo& info, std::size_t rows,
                   const ColumnSource& source);

}  // namespace graspdb
