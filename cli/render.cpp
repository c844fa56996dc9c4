// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>

#include "checks.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/pictures/database_rows.h"
#include "graspdb/pictures/pose_file.h"
#include "graspdb/pictures/view_sheet.h"
#include "graspdb/pictures/write_view.h"
#include "graspdb/renderer/image_io.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct RenderArguments {
  BuildConfig config;
  int grasp = 0, step = BuildConfig{}.steps, view = 0;
  bool free = false;
  std::string pose, database, hand, out;
  std::size_t row = 0;
  double visible_forearm_mm = 1000 * BuildConfig{}.visible_forearm;
  std::optional<int> resolution;
};

struct Rendered {
  LabelledView view;
  ViewSource source;
};

BuildConfig config_of(const RenderArguments& options) {
  BuildConfig config = options.config;
  config.hands = {options.hand.empty() ? default_hand_file() : std::filesystem::path(options.hand)};
  if (config.grasps.empty()) config.grasps = grasp_directory();
  if (options.resolution) config.resolution = *options.resolution;
  config.visible_forearm = options.visible_forearm_mm / 1000;
  return config;
}

void check_place(const char* option, std::size_t value, std::size_t low, std::size_t high) {
  if (value >= low && value <= high) return;
  throw Error({.key = option,
               .expected = fmt::format("{} to {}", low, high),
               .found = fmt::format("{}", value)});
}

Rendered render_grasp(const RenderArguments& options) {
  BuildConfig config = config_of(options);
  config.only = {options.grasp};
  const auto step = static_cast<std::size_t>(options.step);
  const auto view = static_cast<std::size_t>(options.view);
  check_place("--step", step, 1, static_cast<std::size_t>(config.steps));
  check_place("--view", view, 0, static_cast<std::size_t>(config.views) - 1);
  config.objects = options.free ? Objects::kFree : Objects::kHeld;
  const RowPoses poses(config);
  const PoseKey key{.grasp = options.grasp, .step = options.step};
  const Subject subject(poses.hand(0), poses.pose(key));
  const Grasp& grasp = poses.grasp(options.grasp);
  return {subject.seen(poses.camera(subject.pose(), view), poses.light(key, view), kAllLayers),
          {.hand = poses.hand(0).name,
           .variant = options.free ? "free" : "held",
           .grasp = grasp.id,
           .grasp_name = grasp.name,
           .object = grasp.object_name,
           .step = options.step,
           .steps = config.steps,
           .view = view}};
}

Rendered render_pose(const RenderArguments& options) {
  const BuildConfig config = config_of(options);
  check_config(config);
  const PoseFile pose = load_pose(options.pose);
  const Hand hand = with_visible_forearm(load_hand(config.hands[0]), config.visible_forearm);
  const GraspPose bare{.angles = pose.angles};
  const Subject subject(hand,
                        {.pose = bare, .scene = pose_scene(hand, bare, nullptr), .held = false});
  const PosedScene& scene = subject.pose().scene;
  const Camera camera = crop_camera(pose.rotation, scene.center, config.distance,
                                    scene.hand_vertices, config.resolution);
  return {subject.seen(camera, config.light, kAllLayers), {.hand = hand.name, .variant = "free"}};
}

Rendered render_row(const RenderArguments& options) {
  const Database database = Database::open(options.database);
  if (options.row >= database.rows()) {
    throw Error({options.database, "--row", fmt::format("less than {}", database.rows()),
                 fmt::format("{}", options.row)});
  }
  const DatabaseRows rows(database, std::vector{options.row}, options.resolution);
  const Grasp& grasp = rows.grasp(options.row);
  return {rows.view(rows.subject(options.row), options.row, kAllLayers),
          {.hand = database.info().hands[database.hand(options.row)].name,
           .variant = database.info().variants[database.variant(options.row)],
           .grasp = grasp.id,
           .grasp_name = grasp.name,
           .object = grasp.object_name,
           .step = database.step(options.row),
           .steps = database.info().steps,
           .view = database.view(options.row),
           .row = options.row,
           .database = options.database,
           .content_hash = database.content_hash()}};
}

std::string title_of(const ViewSource& source) {
  if (!source.grasp) return source.hand + ", no object";
  const std::string row = source.row ? fmt::format("row {}: ", *source.row) : "";
  return fmt::format("{}grasp {} {}, step {} of {}, view {}, {}, {}", row, *source.grasp,
                     source.grasp_name, *source.step, *source.steps, *source.view, source.hand,
                     source.variant);
}

void run(const RenderArguments& options) {
  const Rendered rendered = !options.database.empty() ? render_row(options)
                            : !options.pose.empty()   ? render_pose(options)
                                                      : render_grasp(options);
  const std::filesystem::path out = options.out;
  write_view(out, rendered.view, rendered.source);
  write_png(out / "sheet.png", draw_view_sheet(rendered.view, title_of(rendered.source)));
  fmt::print("{}\n", options.out);
}

// The three ways to say what is to be seen; each excludes the options of the others.
void add_sources(CLI::App& verb, RenderArguments& options) {
  const char* group = "What is to be seen, one of";
  CLI::Option* grasp = verb.add_option("--grasp", options.grasp, "A grasp's number")
                           ->check(range(1, kLargestGrasp))
                           ->default_str("")
                           ->group(group);
  verb.add_option("--pose", options.pose,
                  "A TOML file with joint angles and a rotation (docs/export.md): no object")
      ->group(group);
  CLI::Option* database =
      verb.add_option("--db", options.database, "The database of --row")->group(group);
  verb.add_option("--step", options.step, "How far the hand has closed, up to --steps")
      ->check(range(1, 20))
      ->needs(grasp);
  verb.add_option("--view", options.view, "One of the --views orientations, from 0")
      ->check(range(0, 99999))
      ->needs(grasp);
  verb.add_flag("--free", options.free, "The hand without the object")->needs(grasp);
  database->needs(verb.add_option("--row", options.row, "A row of --db, from 0")
                      ->check(natural())
                      ->needs(database));
}

// What a database states itself.
void add_scene(CLI::App& verb, RenderArguments& options) {
  CLI::Option* database = verb.get_option("--db");
  const auto add = [&](const char* name, auto& value, const char* text) {
    return verb.add_option(name, value, text)->excludes(database);
  };
  add("--hand", options.hand, "A rigged hand with its rig map beside it [the male hand]");
  add("--grasps", options.config.grasps, "The folder of grasp files [the project's own]");
  add("--steps", options.config.steps, "Steps from rest to the closed hand")->check(range(1, 20));
  add("--views", options.config.views, "Orientations, evenly over all rotations")
      ->check(range(1, 100000));
  add("--distance", options.config.distance, "From the camera to the palm, metres")
      ->check(range(0.2, 5.0));
  add("--forearm", options.visible_forearm_mm, "Visible forearm beyond the wrist, mm")
      ->check(range(0.0, 300.0));
}

}  // namespace

void add_render(CLI::App& app) {
  auto options = std::make_shared<RenderArguments>();
  CLI::App* verb = app.add_subcommand("render", "Write one view as pictures and labels");
  add_sources(*verb, *options);
  add_scene(*verb, *options);
  verb->add_option("--resolution", options->resolution,
                   "Side of the picture, pixels [128, or the database's]")
      ->check(range(16, 1024));
  verb->add_option("--out", options->out, "The folder to write to")
      ->required()
      ->check(output_folder());
  verb->footer(
      "Writes shading, label, part, depth, normals, amodal masks, view.json with camera, pose and\n"
      "keypoints, and sheet.png for looking at all of them (docs/export.md).\n"
      "Example: graspdb render --grasp 9 --step 5 --view 100 --resolution 512 --out pinch");
  verb->callback([options, verb] {
    if (verb->count("--grasp") + verb->count("--pose") + verb->count("--db") != 1)
      throw CLI::RequiredError("Exactly one of --grasp, --pose and --db");
    run(*options);
  });
}

}  // namespace graspdb::cli
