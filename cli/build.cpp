// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "console.h"
#include "graspdb/generator.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct Options {
  BuildConfig config;
  std::string out;
  double visible_forearm_mm = 1000 * BuildConfig{}.visible_forearm;
  std::string hog;
  bool json = false;
};

void run(Options& options) {
  BuildConfig& config = options.config;
  if (config.hands.empty()) config.hands = {default_hand()};
  if (config.grasps.empty()) config.grasps = grasp_directory();
  config.visible_forearm = options.visible_forearm_mm / 1000;
  config.hog = hog_from_name(options.hog, "--hog");
  const BuildReport report =
      build_database(config, options.out, console_progress("rendered", "rows"));
  const double rate = static_cast<double>(report.rows) / report.seconds;
  if (options.json) {
    fmt::print("{}\n", nlohmann::json{{"rows", report.rows},
                                      {"seconds", report.seconds},
                                      {"rows_per_second", rate},
                                      {"bytes", report.bytes},
                                      {"content_hash", report.content_hash}}
                           .dump());
  } else {
    fmt::print("{}: {} rows, {:.1f} MB, in {:.1f} s ({:.0f} rows/s), content {}\n", options.out,
               report.rows, static_cast<double>(report.bytes) / 1e6, report.seconds, rate,
               report.content_hash);
  }
}

}  // namespace

void add_build(CLI::App& app) {
  auto options = std::make_shared<Options>();
  BuildConfig& config = options->config;
  options->hog = hog_name(config.hog);
  CLI::App* verb =
      app.add_subcommand("build", "Render a database of views of hands holding objects");
  verb->add_option("--out", options->out, "The database file to write")->required();
  verb->add_option("--hand", config.hands,
                   "A rigged hand with its rig map beside it; once for each [the male hand]")
      ->allow_extra_args(false);
  verb->add_option("--grasps", config.grasps, "The folder of grasp files [the project's own]");
  verb->add_option("--only", config.only, "Grasp numbers, by commas [all]")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--objects", config.objects,
                   "held: the object hides what it hides; free: the same poses without it; both")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Objects>{
          {"held", Objects::kHeld}, {"free", Objects::kFree}, {"both", Objects::kBoth}}))
      ->default_str("held");
  verb->add_option("--steps", config.steps, "Steps from rest to the closed hand")
      ->check(CLI::Range(1, 20));
  verb->add_option("--views", config.views, "Orientations, evenly over all rotations")
      ->check(CLI::Range(1, 100000));
  verb->add_option("--resolution", config.resolution, "Side of a picture, pixels")
      ->check(CLI::Range(16, 1024));
  verb->add_option("--distance", config.distance, "From the camera to the palm, metres")
      ->check(CLI::Range(0.2, 5.0));
  verb->add_option("--forearm", options->visible_forearm_mm, "Visible forearm beyond the wrist, mm")
      ->check(CLI::Range(0.0, 300.0));
  verb->add_option("--hog", options->hog, "The descriptor's mode")
      ->check(CLI::IsMember({"paper", "edges"}));
  verb->add_option("--threads", config.threads, "Threads, 0 for all processors; changes no byte")
      ->check(CLI::Range(0, 1024));
  verb->add_flag("--json", options->json, "The report as JSON");
  verb->footer("Example: graspdb build --only 1,3,9 --objects both --out small.graspdb");
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
