// SPDX-License-Identifier: MIT
#include "row_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <string_view>

#include "checks.h"
#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "graspdb/grasps/grasp.h"

namespace graspdb::cli {
namespace {

[[noreturn]] void fail_rows(const Database& database, std::string_view found) {
  throw Error({database.path().string(), "--rows",
               fmt::format("rows and ranges of rows below {}, as 0-99,250", database.rows()),
               std::string(found)});
}

// "250" or "0-99".
std::pair<std::size_t, std::size_t> read_range(const Database& database, std::string_view item) {
  const char* const end = item.data() + item.size();
  std::size_t first = 0, last = 0;
  const auto [dash, fault] = std::from_chars(item.data(), end, first);
  last = first;
  const char* rest = dash;
  if (fault == std::errc() && dash != end && *dash == '-') {
    const auto [stop, second_fault] = std::from_chars(dash + 1, end, last);
    rest = second_fault == std::errc() ? stop : dash;
  }
  const bool readable = fault == std::errc() && rest == end;
  if (!readable || first > last || last >= database.rows()) fail_rows(database, item);
  return {first, last};
}

std::vector<std::size_t> all_rows(const Database& database) {
  std::vector<std::size_t> rows(database.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::vector<std::size_t> listed_rows(const Database& database, std::string_view text) {
  std::vector<bool> wanted(database.rows());
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto [first, last] = read_range(database, text.substr(0, comma));
    for (std::size_t row = first; row <= last; ++row) wanted[row] = true;
    if (comma == text.size()) break;
    text.remove_prefix(comma + 1);
  }
  std::vector<std::size_t> rows = all_rows(database);
  std::erase_if(rows, [&](std::size_t row) { return !wanted[row]; });
  return rows;
}

// The first steps of a Fisher-Yates shuffle.
void take_sample(std::vector<std::size_t>& rows, std::size_t count, std::uint64_t seed) {
  if (count >= rows.size()) return;
  RandomStream random(seed);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(rows[i], rows[i + random.below(rows.size() - i)]);
  }
  rows.resize(count);
  std::ranges::sort(rows);
}

}  // namespace

void add_row_selection(CLI::App& verb, RowSelection& selection) {
  verb.add_option("--rows", selection.rows, "Rows and ranges of rows from 0, as 0-99,250 [all]");
  verb.add_option("--grasp", selection.grasps, "Of those only the rows of these grasps [all]")
      ->check(range(1, kLargestGrasp))
      ->delimiter(',')
      ->allow_extra_args(false);
  CLI::Option* sample =
      verb.add_option("--sample", selection.sample, "Of those this many, drawn at random; 0: all")
          ->check(range(0, std::numeric_limits<int>::max()));
  verb.add_option("--seed", selection.seed, "Of the drawing")->check(natural())->needs(sample);
}

std::vector<std::size_t> chosen_rows(const Database& database, const RowSelection& selection) {
  std::vector<std::size_t> rows =
      selection.rows.empty() ? all_rows(database) : listed_rows(database, selection.rows);
  if (!selection.grasps.empty()) {
    std::erase_if(rows, [&](std::size_t row) {
      return std::ranges::find(selection.grasps, database.grasp(row)) == selection.grasps.end();
    });
  }
  if (rows.empty()) {
    throw Error({.file = database.path().string(), .expected = "rows", .found = "none of these"});
  }
  if (selection.sample > 0) {
    take_sample(rows, static_cast<std::size_t>(selection.sample), selection.seed);
  }
  return rows;
}

std::vector<std::size_t> spread_rows(std::size_t rows, std::size_t count) {
  constexpr double kGoldenSection = 0.6180339887498949;
  count = std::min(count, rows);
  std::vector<std::size_t> spread;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * rows / count, end = (i + 1) * rows / count;
    const double place = std::fmod(static_cast<double>(i + 1) * kGoldenSection, 1.0);
    spread.push_back(begin + static_cast<std::size_t>(place * static_cast<double>(end - begin)));
  }
  return spread;
}

}  // namespace graspdb::cli
