// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <optional>
#include <string>

#include "checks.h"
#include "help.h"
#include "verbs.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUse = 2;

void describe(CLI::App& app) {
  app.name("graspdb");
  app.set_version_flag("--version", "graspdb " GRASPDB_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<graspdb::cli::HelpFormatter>());
  app.get_formatter()->column_width(38);
  app.option_defaults()->always_capture_default();
}

// Faults are told once, by us.
void silence_libraries() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  constexpr const char* kQuiet = "-8";  // AV_LOG_QUIET
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", kQuiet, 0);
}

// The word in the place of a verb that is none: CLI11 tells only that a verb is wanted.
std::optional<std::string> unknown_verb(const CLI::App& app) {
  const CLI::App* inner = &app;
  while (!inner->get_subcommands().empty()) inner = inner->get_subcommands().front();
  const auto unknown = inner->remaining();
  if (inner->get_require_subcommand_min() == 0 || unknown.empty()) return std::nullopt;
  return unknown.front();
}

int report_wrong_use(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  if (const auto word = unknown_verb(app)) {
    fmt::print(stderr, "graspdb: no such verb: {}; graspdb --help lists them\n", *word);
  } else {
    app.exit(error);
  }
  return kWrongUse;
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = graspdb::cli;
  silence_libraries();
  cv::setNumThreads(1);  // our own loops are parallel where it pays
  CLI::App app("Views of hands that hold objects, and a tracker that reads them");
  describe(app);
  for (const auto add :
       {cli::add_build, cli::add_merge, cli::add_info, cli::add_diff, cli::add_query,
        cli::add_render, cli::add_export, cli::add_track, cli::add_find, cli::add_sequence,
        cli::add_samples, cli::add_scenes, cli::add_eval, cli::add_tune, cli::add_bench,
        cli::add_grasp, cli::add_hand}) {
    add(app);
  }
  cli::refuse_empty_texts(app);
  app.footer(
      "Examples:\n"
      "  graspdb build --objects both --out hands.graspdb\n"
      "  graspdb track hands.graspdb video.mp4 --video overlay.mp4 --json poses.jsonl\n"
      "  graspdb VERB --help tells a verb's options");
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& status) {
    return status.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return report_wrong_use(app, error);
  } catch (const std::exception& error) {
    fmt::print(stderr, "graspdb: {}\n", error.what());
    return kFailed;
  }
}
