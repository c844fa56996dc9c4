// SPDX-License-Identifier: MIT
// The tracker's options, shared by `track` and `eval`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "graspdb/tracker.h"

namespace graspdb::cli {

struct TrackerSettings {
  TrackerOptions values;
  std::string temporal = "kde";
  std::string search = "exact";
};

inline void add_tracker_options(CLI::App& verb, TrackerSettings& settings) {
  TrackerOptions& values = settings.values;
  verb.add_option("--temporal", settings.temporal, "How a frame depends on the one before")
      ->check(CLI::IsMember({"none", "gaussian", "kde"}));
  verb.add_option("--search", settings.search, "How neighbours are found")
      ->check(CLI::IsMember({"exact", "scan", "lsh"}));
  verb.add_option("-k,--neighbours", values.neighbours, "Neighbours looked up")
      ->check(CLI::Range(1, 1000));
  verb.add_option("--sigma-hog", values.sigma_hog, "Of the descriptor distance")
      ->check(CLI::Range(0.01, 100.0));
  verb.add_option("--sigma-stretch", values.sigma_stretch,
                  "Of the box's log aspect ratio against the row's")
      ->check(CLI::Range(0.01, 100.0));
  verb.add_option("--sigma-pose", values.sigma_pose,
                  "Of the pose around the last answer (gaussian)")
      ->check(CLI::Range(0.01, 100.0));
  verb.add_option("--bandwidth", values.bandwidth, "Of the pose around each last hypothesis (kde)")
      ->check(CLI::Range(0.01, 100.0));
  verb.add_option("--max-distance", values.max_distance,
                  "A nearest descriptor further away is no hand")
      ->check(CLI::Range(0.01, 1000.0));
}

}  // namespace graspdb::cli
