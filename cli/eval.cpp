// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "console.h"
#include "graspdb/error.h"
#include "graspdb/evaluate.h"
#include "graspdb/file.h"
#include "report.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct Options {
  std::string database, sequences, out;
  std::vector<double> alphas = EvalOptions{}.alphas;
  std::uint64_t seed = 0;
  TrackerSettings tracker;
  bool json = false;
};

nlohmann::json to_json(const Summary& s) {
  return {{"pose_error", s.pose_error},
          {"rotation_deg",
           {{"mean", s.rotation_deg.mean},
            {"median", s.rotation_deg.median},
            {"p90", s.rotation_deg.p90}}},
          {"joint_deg", s.joint_deg},
          {"mpjpe_mm", s.mpjpe_mm},
          {"pa_mpjpe_mm", s.pa_mpjpe_mm},
          {"flips", s.flips}};
}

nlohmann::json to_json(const EvalRow& row, const Baselines& base) {
  nlohmann::json line = to_json(row.errors);
  line.update({{"sequence", row.sequence},
               {"temporal", temporal_name(row.temporal)},
               {"alpha", row.alpha},
               {"valid", row.valid},
               {"smallest_box_px", row.smallest_box_px},
               {"median_distance", row.median_distance},
               {"oracle", to_json(base.oracle)},
               {"random", to_json(base.random)},
               {"constant", to_json(base.constant)}});
  return line;
}

std::vector<std::filesystem::path> sequence_files(const std::filesystem::path& given) {
  if (std::filesystem::is_regular_file(given)) return {given};
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(given)) {
    for (const auto& entry : std::filesystem::directory_iterator(given)) {
      if (entry.path().string().ends_with(".seq.toml")) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw Error({.file = given.string(), .expected = "sequences (*.seq.toml)", .found = "none"});
  return files;
}

void print(const SequenceEvaluation& result) {
  const EvalRow& first = result.rows.front();
  fmt::print("\n{}: smallest hand box {:.0f} px, {:.0f} % of frames valid at alpha {}\n",
             first.sequence, first.smallest_box_px, 100 * first.valid, first.alpha);
  std::vector<std::pair<std::string, Summary>> lines;
  for (const EvalRow& row : result.rows) {
    lines.emplace_back(fmt::format("{} alpha {} %", temporal_name(row.temporal), row.alpha),
                       row.errors);
  }
  print_error_table(lines, result.baselines);
}

void run(const Options& options) {
  const Database database = Database::open(options.database);
  const auto search = open_search(database, options.tracker.search);
  EvalOptions settings{
      .alphas = options.alphas, .tracker = options.tracker.values, .seed = options.seed};
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& file : sequence_files(options.sequences)) {
    const SequenceRenderer sequence(load_sequence(file));
    const SequenceEvaluation result =
        evaluate(database, *search, sequence, settings,
                 console_progress(sequence.spec().name + ":", "runs"));
    for (const EvalRow& row : result.rows) rows.push_back(to_json(row, result.baselines));
    if (!options.json) print(result);
  }
  const std::string text = nlohmann::json{{"rows", rows}}.dump(1) + "\n";
  if (options.json) fmt::print("{}", text);
  if (!options.out.empty()) write_text(std::filesystem::path(options.out) / "eval.json", text);
}

}  // namespace

void add_eval(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("eval", "Track rendered sequences and hold the answers against the truth");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--sequences", options->sequences, "A folder of *.seq.toml, or one of them")
      ->required();
  verb->add_option("--alphas", options->alphas, "Segmentation noise, percent, by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0.0, 100.0));
  verb->add_option("--seed", options->seed, "Seed of the segmentation noise");
  verb->add_option("--out", options->out, "A folder for eval.json");
  verb->add_flag("--json", options->json, "JSON instead of tables");
  add_tracker_options(*verb, options->tracker);
  verb->remove_option(verb->get_option("--temporal"));  // all models are run
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
