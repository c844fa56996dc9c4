// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <opencv2/core.hpp>

#include "verbs.h"

namespace {

constexpr int kFailed = 1;
constexpr int kWrongUse = 2;

void describe(CLI::App& app) {
  app.name("graspdb");
  app.set_version_flag("--version", "graspdb " GRASPDB_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(38);
  app.option_defaults()->always_capture_default();
  app.footer(
      "Examples:\n"
      "  graspdb build --objects both --out hands.graspdb\n"
      "  graspdb track hands.graspdb video.mp4 --video overlay.mp4 --json poses.jsonl\n"
      "  graspdb VERB --help tells a verb's options");
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = graspdb::cli;
  cv::setNumThreads(1);  // our own loops are parallel where it pays
  CLI::App app("Views of hands that hold objects, and a tracker that reads them");
  describe(app);
  for (const auto add :
       {cli::add_build, cli::add_info, cli::add_index, cli::add_track, cli::add_sequence,
        cli::add_eval, cli::add_bench, cli::add_grasp, cli::add_hand}) {
    add(app);
  }
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    const bool asked_for_help = error.get_exit_code() == 0;
    return app.exit(error) == 0 && asked_for_help ? 0 : kWrongUse;
  } catch (const std::exception& error) {
    fmt::print(stderr, "graspdb: {}\n", error.what());
    return kFailed;
  }
}
