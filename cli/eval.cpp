// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "console.h"
#include "eval_files.h"
#include "graspdb/error.h"
#include "graspdb/evaluate.h"
#include "graspdb/file.h"
#include "graspdb/photoreal.h"
#include "nearest_object.h"
#include "report.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct Options {
  std::string database, sequences, photoreal, out;
  std::vector<double> alphas = EvalOptions{}.alphas;
  std::uint64_t seed = 0;
  std::optional<double> fps;
  TrackerSettings tracker;
  bool json = false;
};

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

void require_hand(const SequenceSpec& spec) {
  const auto& hand = spec.hand.file;
  if (hand.empty() || std::filesystem::exists(hand)) return;
  throw Error({spec.file.string(), "hand.file", "a hand; scripts/fetch_hands.sh fetches WebXR's",
               "no file " + hand.string()});
}

// All of them before the first is run, so that a broken one is not found after minutes.
std::vector<SequenceSpec> load_all(const Options& options) {
  std::vector<SequenceSpec> specs;
  std::set<std::string> names;
  for (const auto& file : sequence_files(options.sequences)) {
    specs.push_back(load_sequence(file));
    if (options.fps) specs.back().frames_per_second = *options.fps;
    require_hand(specs.back());
    if (names.insert(specs.back().name).second) continue;
    throw Error({file.string(), "name", "one that no other sequence has", specs.back().name});
  }
  return specs;
}

// Those that have photoreal frames.
std::vector<SequenceSpec> with_frames(std::vector<SequenceSpec> specs,
                                      const std::filesystem::path& folder) {
  std::erase_if(specs, [&](const auto& spec) { return !has_photoreal_frames(spec, folder); });
  if (!specs.empty()) return specs;
  throw Error({.file = folder.string(),
               .expected = "a folder of frames with the name of a sequence",
               .found = "none"});
}

// For the same reason.
void require_folder(const std::filesystem::path& out) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) throw Error({.file = out.string(), .expected = "a folder", .found = error.message()});
}

void write_all(const Options& options, const EvalReport& report, const std::string& json) {
  const std::filesystem::path out = options.out;
  write_text(out / "frames.csv", frames_csv(report));
  write_text(out / "runs.csv", runs_csv(report));
  write_text(out / "eval.json", json);
}

EvalOptions eval_options(const Options& options) {
  EvalOptions settings{.trackers = {}, .alphas = options.alphas, .seed = options.seed};
  for (const TemporalModel model : kTemporalModels)
    settings.trackers.push_back(options.tracker.options(model));
  return settings;
}

void run(const Options& options) {
  const Database database = Database::open(options.database);
  std::vector<SequenceSpec> specs = load_all(options);
  const bool photoreal = !options.photoreal.empty();
  if (photoreal) specs = with_frames(std::move(specs), options.photoreal);
  if (!options.out.empty()) require_folder(options.out);
  const PoseGrid grid(database);
  const auto search = open_search(database, options.tracker.search);
  const EvalOptions settings = eval_options(options);
  const DatabaseObjects objects(database);
  EvalReport report;
  for (SequenceSpec& spec : specs) {
    const std::string object = objects.beside(spec);
    const SequenceRenderer renderer(std::move(spec));
    const SequenceFrames frames =
        photoreal ? photoreal_frames(renderer, options.photoreal) : render_frames(renderer);
    report.sequences.push_back(evaluate(database, grid, *search, frames, settings,
                                        console_progress(frames.name + ":", "passes")));
    if (options.json) continue;
    print(report.sequences.back());
    fmt::print("object: {}\n", object);
  }
  report.set = summarize_set(report.sequences, options.seed);
  if (!options.json) print(report.set, report.sequences.front().kind, report.sequences.size());
  nlohmann::json json = eval_json(report);
  json["database"] = {{"content_hash", database.content_hash()}, {"rows", database.rows()}};
  for (const TrackerOptions& tracker : settings.trackers)
    json["trackers"][temporal_name(tracker.temporal)] = options_json(tracker);
  json["search"] = options.tracker.search;
  json["seed"] = options.seed;
  json["fps"] = options.fps ? nlohmann::json(*options.fps) : nlohmann::json();
  const std::string text = json.dump(1) + "\n";
  if (options.json) fmt::print("{}", text);
  if (!options.out.empty()) write_all(options, report, text);
}

}  // namespace

void add_eval(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("eval", "Track rendered sequences and hold the answers against the truth");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--sequences", options->sequences, "A folder of *.seq.toml, or one of them")
      ->required();
  verb->add_option("--photoreal", options->photoreal,
                   "A folder of photoreal frames, NAME/000000.jpg ...: only sequences that have "
                   "them are run, on them, with the hand found by its colour");
  verb->add_option("--alphas", options->alphas, "Segmentation noise, percent, by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0.0, 100.0));
  verb->add_option("--seed", options->seed, "Seed of the segmentation noise");
  verb->add_option("--fps", options->fps, "Frames a second instead of the files'")
      ->check(CLI::Range(kMinFramesPerSecond, kMaxFramesPerSecond))
      ->check(check_not_nan);
  verb->add_option("--out", options->out, "A folder for eval.json, frames.csv and runs.csv");
  verb->add_flag("--json", options->json, "JSON instead of tables");
  add_tracker_options(*verb, options->tracker);
  verb->remove_option(verb->get_option("--temporal"));  // all models are run
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
