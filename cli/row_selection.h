// SPDX-License-Identifier: MIT
// Which rows of a database are wanted, as options say it.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "graspdb/database/database.h"

namespace graspdb::cli {

struct RowSelection {
  std::string rows;         // "0-99,250"; empty: all
  std::vector<int> grasps;  // of those only rows of these ids; empty: of all
  int sample = 0;           // of those as many at random; 0: all
  std::uint64_t seed = 0;
};

// Adds --rows, --grasp, --sample and --seed.
void add_row_selection(CLI::App& verb, RowSelection& selection);

// Ascending, each once. Throws Error naming the option that is wrong or leaves no row.
std::vector<std::size_t> chosen_rows(const Database& database, const RowSelection& selection);

// `count` rows spread evenly over the database (fewer when it has fewer), one in each stretch of
// equal length, at places that do not repeat with its views and steps.
std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t count);

}  // namespace graspdb::cli
