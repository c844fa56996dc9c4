// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "checks.h"
#include "console.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/evaluation/eval_files.h"
#include "graspdb/evaluation/evaluate.h"
#include "graspdb/evaluation/nearest_object.h"
#include "graspdb/evaluation/tables.h"
#include "sequence_set.h"
#include "tracker_options.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct EvalArguments {
  std::string database, out;
  SequenceSetOptions set;
  NoiseOptions noise{.alphas = EvalOptions{}.alphas};
  TrackerSettings tracker;
  bool json = false;
};

FolderContent eval_content() {
  return {.kind = "an evaluation",
          .marker = ".graspdb-eval",
          .files = {"frames.csv", "runs.csv", "eval.json"}};
}

void write_all(const EvalArguments& options, const EvalReport& report, const std::string& text) {
  const std::filesystem::path out = options.out;
  write_text(out / "frames.csv", frames_csv(report));
  write_text(out / "runs.csv", runs_csv(report));
  write_text(out / "eval.json", text);
}

EvalOptions eval_options(const EvalArguments& options, const Database& database) {
  EvalOptions settings{.trackers = {}, .alphas = options.noise.alphas, .seed = options.noise.seed};
  for (const TemporalModel model : kTemporalModels)
    settings.trackers.push_back(options.tracker.options(model, database));
  return settings;
}

void run(const EvalArguments& options) {
  const Database database = Database::open(options.database);
  SequenceSet set(options.set);
  // Before the first sequence is run, not after minutes.
  if (!options.out.empty()) claim_folder(options.out, eval_content());
  const PoseGrid grid(database);
  const auto search = open_search(database, options.tracker.search);
  set.choose_hands_by(database, *search);
  const EvalOptions settings = eval_options(options, database);
  const DatabaseObjects objects(database);
  EvalReport report;
  for (const SequenceSpec& spec : set.specs()) {
    const auto renderer = set.renderer(spec);
    if (!renderer) continue;
    const SequenceFrames frames = set.frames(*renderer);
    report.sequences.push_back(evaluate(database, grid, *search, frames, settings,
                                        console_progress(frames.name + ":", "passes")));
    if (options.json) continue;
    fmt::print("{}", sequence_table(report.sequences.back()));
    fmt::print("object: {}\n", objects.beside(renderer->spec()));
  }
  if (report.sequences.empty()) throw Error("every sequence is left out");
  report.set = summarize_set(report.sequences, options.noise.seed);
  if (!options.json) {
    fmt::print("{}",
               set_tables(report.set, report.sequences.front().kind, report.sequences.size()));
  }
  nlohmann::json all = eval_json(report);
  all["database"] = {{"content_hash", database.content_hash()}, {"rows", database.rows()}};
  for (const TrackerOptions& tracker : settings.trackers)
    all["trackers"][temporal_name(tracker.temporal)] = options_json(tracker);
  all["search"] = options.tracker.search;
  all["seed"] = options.noise.seed;
  all.update(set.json());
  const std::string text = all.dump(1) + "\n";
  if (options.json) fmt::print("{}", text);
  if (!options.out.empty()) write_all(options, report, text);
}

}  // namespace

void add_eval(CLI::App& app) {
  auto options = std::make_shared<EvalArguments>();
  CLI::App* verb =
      app.add_subcommand("eval", "Track rendered sequences and hold the answers against the truth");
  verb->add_option("DB", options->database, "The database")->required();
  add_sequence_options(*verb, options->set);
  add_noise_options(*verb, options->noise);
  verb->add_option("--out", options->out, "A folder for eval.json, frames.csv and runs.csv")
      ->check(output_folder());
  verb->add_flag("--json", options->json, "JSON instead of tables");
  add_tracker_options(*verb, options->tracker);
  verb->remove_option(verb->get_option("--temporal"));  // all models are run
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
