// SPDX-License-Identifier: MIT
// The tracker's options, shared by `track` and `eval`.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "graspdb/tracker.h"

namespace graspdb::cli {

// What is not given is as it was chosen for the temporal model.
struct TrackerSettings {
  std::string temporal = "kde";
  std::string search = "exact";
  std::optional<int> neighbours, kept;
  std::optional<double> sigma_hog, sigma_stretch, sigma_pose, bandwidth, max_distance;

  TrackerOptions options(TemporalModel model) const {
    TrackerOptions options = tuned_options(model);
    const auto set = [](const auto& given, auto& value) {
      if (given) value = *given;
    };
    set(neighbours, options.neighbours);
    set(kept, options.kept);
    set(sigma_hog, options.sigma_hog);
    set(sigma_stretch, options.sigma_stretch);
    set(sigma_pose, options.sigma_pose);
    set(bandwidth, options.bandwidth);
    set(max_distance, options.max_distance);
    return options;
  }
  TrackerOptions options() const { return options(temporal_from_name(temporal)); }
};

// One value for all models, or each model's own: "20", "none 20, gaussian 20, ...".
template <typename Value>
std::string tuned_default(Value TrackerOptions::*member) {
  std::string all, first = fmt::format("{:g}", double(tuned_options(kTemporalModels[0]).*member));
  bool same = true;
  for (const TemporalModel model : kTemporalModels) {
    const std::string value = fmt::format("{:g}", double(tuned_options(model).*member));
    same = same && value == first;
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", temporal_name(model), value);
  }
  return same ? first : all;
}

inline void add_tracker_options(CLI::App& verb, TrackerSettings& settings) {
  verb.add_option("--temporal", settings.temporal, "How a frame depends on the one before")
      ->check(CLI::IsMember({"none", "gaussian", "kde", "successors"}));
  verb.add_option("--search", settings.search, "How neighbours are found")
      ->check(CLI::IsMember({"exact", "scan", "lsh"}));
  verb.add_option("-k,--neighbours", settings.neighbours, "Neighbours looked up")
      ->check(CLI::Range(1, 1000))
      ->default_str(tuned_default(&TrackerOptions::neighbours));
  verb.add_option("--kept", settings.kept, "Hypotheses that the next frame remembers")
      ->check(CLI::Range(1, 1000))
      ->default_str(tuned_default(&TrackerOptions::kept));
  verb.add_option("--sigma-hog", settings.sigma_hog, "Of the descriptor distance")
      ->check(CLI::Range(0.01, 100.0))
      ->default_str(tuned_default(&TrackerOptions::sigma_hog));
  verb.add_option("--sigma-stretch", settings.sigma_stretch,
                  "Of the box's log aspect ratio against the row's")
      ->check(CLI::Range(0.01, 100.0))
      ->default_str(tuned_default(&TrackerOptions::sigma_stretch));
  verb.add_option("--sigma-pose", settings.sigma_pose,
                  "Of the pose around the last answer (gaussian)")
      ->check(CLI::Range(0.01, 100.0))
      ->default_str(tuned_default(&TrackerOptions::sigma_pose));
  verb.add_option("--bandwidth", settings.bandwidth,
                  "Of the pose around each last hypothesis (kde, successors)")
      ->check(CLI::Range(0.01, 100.0))
      ->default_str(tuned_default(&TrackerOptions::bandwidth));
  verb.add_option("--max-distance", settings.max_distance,
                  "A nearest descriptor further away is no hand")
      ->check(CLI::Range(0.01, 1000.0))
      ->default_str(tuned_default(&TrackerOptions::max_distance));
}

}  // namespace graspdb::cli
