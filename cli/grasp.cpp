// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "checks.h"
#include "console.h"
#include "grasp_template.h"
#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp_report.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/pictures/grasp_sheet.h"
#include "graspdb/renderer/image_io.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct GraspArguments {
  std::string file;
  std::string hand;
  std::string out;
  bool json = false;
  bool plain = false;
  bool steps = false;
};

std::vector<Grasp> chosen(const GraspArguments& options) {
  if (!options.file.empty()) return {load_grasp(options.file)};
  return load_grasps(grasp_directory());
}

std::filesystem::path directory_of(const GraspArguments& options) {
  return options.file.empty() ? grasp_directory()
                              : std::filesystem::path(options.file).parent_path();
}

Hand chosen_hand(const GraspArguments& options) {
  return load_hand(options.hand.empty() ? default_hand_file()
                                        : std::filesystem::path(options.hand));
}

void run_list() {
  for (const Grasp& grasp : load_grasps(grasp_directory())) {
    fmt::print("{:3}  {:26} {:13} {}\n", grasp.id, grasp.name, grasp.type, grasp.object_name);
  }
}

void run_check(const GraspArguments& options) {
  const std::vector<Grasp> grasps = chosen(options);
  const Hand hand = chosen_hand(options);
  const JointAngles rest = load_rest_pose(directory_of(options));
  std::vector<GraspCheck> checks(grasps.size());
  parallel_for(grasps.size(), 0, [&](std::size_t i) {
    checks[i] = check_grasp(grasps[i], hand, rest, closed_pose(grasps[i], hand));
  });
  nlohmann::json list = nlohmann::json::array();
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    list.push_back(check_json(grasps[i], hand, checks[i]));
  }
  if (options.json) {
    fmt::print("{}\n", nlohmann::json{{"grasps", list}}.dump(1));
  } else if (options.file.empty()) {
    fmt::print("{}", summary_table(grasps, checks));
  } else {
    fmt::print("{}", step_table(grasps.front(), checks.front()));
  }
  const auto failed =
      std::count_if(checks.begin(), checks.end(), [](const GraspCheck& c) { return !c.pass; });
  if (failed > 0) throw Error(fmt::format("{} of {} grasps fail", failed, grasps.size()));
}

void run_close(const GraspArguments& options) {
  const std::vector<Grasp> grasps = chosen(options);
  const Hand hand = chosen_hand(options);
  std::vector<GraspPose> poses(grasps.size());
  const Progress progress = console_progress("closed", "grasps");
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(grasps.size(), 0, [&](std::size_t i) {
    poses[i] = close_grasp(grasps[i], hand);
    const std::lock_guard lock(mutex);
    progress(++done, grasps.size());
  });
  const auto file = keep_closed_poses(grasps, hand, poses);
  fmt::print("{}\n", file.string());
}

ColorImage draw(const GraspArguments& options, std::vector<Grasp> grasps, const Hand& hand) {
  for (Grasp& grasp : grasps) grasp = fitted_to(hand, std::move(grasp));
  const JointAngles rest = load_rest_pose(directory_of(options));
  std::map<int, GraspPose> closed;
  for (const Grasp& grasp : grasps) closed[grasp.id] = closed_pose(grasp, hand);
  if (options.steps) return draw_step_page(hand, grasps, rest, closed, options.plain);
  if (options.file.empty()) return draw_grasp_page(hand, grasps, closed, options.plain);
  return draw_grasp_sheet(hand, grasps.front(), rest, closed.begin()->second);
}

void run_sheet(const GraspArguments& options) {
  write_png(options.out, draw(options, chosen(options), chosen_hand(options)));
  fmt::print("{}\n", options.out);
}

void add_new(CLI::App& grasp) {
  struct NewOptions {
    std::string name, directory = ".";
  };
  auto options = std::make_shared<NewOptions>();
  CLI::App* verb = grasp.add_subcommand("new", "Write a commented grasp file to start from");
  verb->add_option("NAME", options->name, "Of the grasp, e.g. \"Jar Lid\"")->required();
  verb->add_option("--out", options->directory, "The folder to write to")->check(output_folder());
  verb->callback([options] {
    fmt::print("{}\n", write_new_grasp(options->name, options->directory).string());
  });
}

void add_common(CLI::App& verb, GraspArguments& options) {
  verb.add_option("FILE", options.file, "One grasp file [all of the project's grasps]");
  verb.add_option("--hand", options.hand, "A rigged hand [the male hand]");
}

}  // namespace

void add_grasp(CLI::App& app) {
  auto options = std::make_shared<GraspArguments>();
  CLI::App* grasp = app.add_subcommand("grasp", "List, check, close and draw grasps");
  grasp->require_subcommand(1);
  grasp->add_subcommand("list", "The grasps with type and object")->callback([] { run_list(); });
  CLI::App* check = grasp->add_subcommand(
      "check", "Measure penetration, overlap and contacts; exit 1 when a gate fails");
  add_common(*check, *options);
  check->add_flag("--json", options->json, "As JSON");
  check->callback([options] { run_check(*options); });
  CLI::App* close = grasp->add_subcommand(
      "close", "Close the hand by contact and store the pose beside the grasps");
  add_common(*close, *options);
  close->callback([options] { run_close(*options); });
  CLI::App* sheet = grasp->add_subcommand("sheet", "Draw closed grasps from several sides");
  add_common(*sheet, *options);
  sheet->add_option("--out", options->out, "The PNG to write")
      ->required()
      ->check(output_file({".png"}));
  sheet->add_flag("--plain", options->plain, "Without names and numbers");
  sheet->add_flag("--steps", options->steps, "The five steps of each grasp");
  sheet->callback([options] { run_sheet(*options); });
  add_new(*grasp);
}

}  // namespace graspdb::cli
