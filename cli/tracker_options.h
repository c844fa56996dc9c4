// SPDX-License-Identifier: MIT
// The tracker's options, shared by `track`, `eval`, `tune` and `bench`.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>

#include "graspdb/database/search.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb::cli {

struct TrackerSettings {
  std::string temporal = "kde";
  std::string search = kDefaultSearch;
  std::array<std::optional<double>, kTrackerNumbers.size()> numbers;

  // What is not given is as it was chosen for the temporal model and the database's rows.
  TrackerOptions options(TemporalModel model, const Database& database) const;
  TrackerOptions options(const Database& database) const {
    return options(temporal_from_name(temporal), database);
  }
};

void add_tracker_options(CLI::App& verb, TrackerSettings& settings);

}  // namespace graspdb::cli
