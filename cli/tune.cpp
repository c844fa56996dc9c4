// SPDX-License-Identifier: MIT
// Many trackers at once over the same frames: what scripts/tune.py chooses from.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "checks.h"
#include "console.h"
#include "graspdb/core/error.h"
#include "graspdb/evaluation/eval_files.h"
#include "sequence_set.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

using nlohmann::json;

struct TuneArguments {
  std::string database, trackers, search = kDefaultSearch;
  SequenceSetOptions set;
  NoiseOptions noise{.alphas = {0, 1}};
};

void set_option(TrackerOptions& options, const std::string& key, double value,
                const std::string& file) {
  const auto number =
      std::find_if(kTrackerNumbers.begin(), kTrackerNumbers.end(),
                   [&](const TrackerNumber& known) { return known.tuned && key == known.key; });
  if (number == kTrackerNumbers.end())
    throw Error({file, key, "an option of the tracker", "none of that name"});
  if (!(value >= number->low && value <= number->high))
    throw Error(
        {file, key, fmt::format("{} to {}", number->low, number->high), fmt::format("{}", value)});
  set_number(options, *number, value);
}

std::string tuned_keys() {
  std::string all;
  for (const TrackerNumber& number : kTrackerNumbers) {
    if (number.tuned) all += fmt::format("{}{}", all.empty() ? "" : ", ", number.key);
  }
  return all;
}

TrackerOptions tracker_of(const json& line, const std::string& file, DescriptorKind kind) {
  TrackerOptions options = tuned_options(temporal_from_name(line.at("temporal")), kind);
  for (const auto& [key, value] : line.items()) {
    if (key != "temporal") set_option(options, key, value.get<double>(), file);
  }
  return options;
}

std::vector<TrackerOptions> read_trackers(const std::string& path, DescriptorKind kind) {
  std::ifstream file(path);
  std::vector<TrackerOptions> trackers;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string where = fmt::format("{}: line {}", path, ++number);
    try {
      trackers.push_back(tracker_of(json::parse(line), where, kind));
    } catch (const json::exception& error) {
      throw Error({where, "", "{\"temporal\": NAME, OPTION: NUMBER, ...}", error.what()});
    }
  }
  if (trackers.empty())
    throw Error({.file = path, .expected = "a line for each tracker", .found = "none"});
  return trackers;
}

// One tracker's errors in one sequence, over all alphas.
json mean_errors(const SequenceEvaluation& sequence, std::size_t tracker, std::size_t alphas) {
  double pose_error = 0, rotation = 0, joints = 0;
  for (std::size_t i = tracker * alphas; i < (tracker + 1) * alphas; ++i) {
    pose_error += sequence.runs[i].errors.mean[kPoseError];
    rotation += sequence.runs[i].errors.mean[kRotationDeg];
    joints += sequence.runs[i].errors.mean[kJointDeg];
  }
  const auto count = static_cast<double>(alphas);
  return {{"pose_error", pose_error / count},
          {"rotation_deg", rotation / count},
          {"joint_deg", joints / count}};
}

void run(const TuneArguments& options) {
  const Database database = Database::open(options.database);
  const EvalOptions settings{.trackers = read_trackers(options.trackers, descriptor_kind(database)),
                             .alphas = options.noise.alphas,
                             .seed = options.noise.seed};
  SequenceSet set(options.set);
  const PoseGrid grid(database);
  const auto search = open_search(database, options.search);
  set.choose_hands_by(database, *search);
  std::vector<json> lines;
  for (const TrackerOptions& tracker : settings.trackers) {
    lines.push_back(options_json(tracker));
    lines.back()["temporal"] = temporal_name(tracker.temporal);
  }
  for (const SequenceSpec& spec : set.specs()) {
    const auto renderer = set.renderer(spec);
    if (!renderer) continue;
    const SequenceEvaluation result =
        evaluate(database, grid, *search, set.frames(*renderer), settings,
                 console_progress(spec.name + ":", "passes"));
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i]["sequences"][spec.name] = mean_errors(result, i, options.noise.alphas.size());
  }
  for (const json& line : lines) fmt::print("{}\n", line.dump());
}

}  // namespace

void add_tune(CLI::App& app) {
  auto options = std::make_shared<TuneArguments>();
  CLI::App* verb =
      app.add_subcommand("tune", "Errors of many trackers over the same sequences, a line each");
  verb->group("");  // for scripts/tune.py
  verb->add_option("DB", options->database, "The database")->required();
  add_sequence_options(*verb, options->set);
  verb->add_option("--trackers", options->trackers,
                   "A file with a JSON object a line: temporal, and what is not as chosen for it "
                   "of " +
                       tuned_keys())
      ->required();
  add_noise_options(*verb, options->noise);
  verb->add_option("--search", options->search, "How neighbours are found")
      ->check(one_of(search_names()));
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
