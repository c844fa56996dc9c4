// SPDX-License-Identifier: MIT
// The tracker's options, shared by `track`, `eval`, `tune` and `bench`.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>

#include "graspdb/tracker.h"

namespace graspdb::cli {

// One of the numbers among them.
struct TrackerNumber {
  const char* key;    // in JSON
  const char* names;  // on the command line
  std::variant<int TrackerOptions::*, double TrackerOptions::*> member;
  double low, high;
  const char* help;
  bool tuned = true;  // `tune` sets it
};
inline constexpr std::array<TrackerNumber, 7> kTrackerNumbers = {
    {{"neighbours", "-k,--neighbours", &TrackerOptions::neighbours, 1, 1000,
      "Neighbours looked up"},
     {"kept", "--kept", &TrackerOptions::kept, 1, 1000, "Hypotheses that the next frame remembers"},
     {"sigma_hog", "--sigma-hog", &TrackerOptions::sigma_hog, 0.01, 100,
      "Of the descriptor distance"},
     {"sigma_stretch", "--sigma-stretch", &TrackerOptions::sigma_stretch, 0.01, 100,
      "Of the box's log aspect ratio against the row's"},
     {"sigma_pose", "--sigma-pose", &TrackerOptions::sigma_pose, 0.01, 100,
      "Of the pose around the last answer (gaussian)"},
     {"bandwidth", "--bandwidth", &TrackerOptions::bandwidth, 0.01, 100,
      "Of the pose around each last hypothesis (kde, successors)"},
     {"max_distance", "--max-distance", &TrackerOptions::max_distance, 0.01, 1000,
      "A nearest descriptor further away is no hand", false}}};

void set_number(TrackerOptions& options, const TrackerNumber& number,
                double value);                               // within its range
nlohmann::json options_json(const TrackerOptions& options);  // all the numbers

struct TrackerSettings {
  std::string temporal = "kde";
  std::string search = "exact";
  std::array<std::optional<double>, kTrackerNumbers.size()> numbers;

  // What is not given is as it was chosen for the temporal model.
  TrackerOptions options(TemporalModel model) const;
  TrackerOptions options() const { return options(temporal_from_name(temporal)); }
};

void add_tracker_options(CLI::App& verb, TrackerSettings& settings);

}  // namespace graspdb::cli
