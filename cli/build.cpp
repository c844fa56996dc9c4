// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "checks.h"
#include "console.h"
#include "graspdb/core/error.h"
#include "graspdb/generator/generator.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/rig/rig.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct BuildArguments {
  BuildConfig given;                                        // as options say
  std::vector<std::function<void(BuildConfig&)>> override;  // what was given, over a --config
  std::string config_file, preset;
  double visible_forearm_mm = 1000 * BuildConfig{}.visible_forearm;
  std::string hog = hog_name(BuildConfig{}.hog);
  std::string out, work, shard = "0/1";
  int threads = 0;
  bool json = false;
};

BuildConfig config_of(const BuildArguments& options) {
  BuildConfig config;
  if (!options.preset.empty()) config = load_config(preset_file(options.preset));
  if (!options.config_file.empty()) config = load_config(options.config_file);
  for (const auto& override : options.override) override(config);
  if (config.hands.empty()) config.hands = {default_hand_file()};
  if (config.grasps.empty()) config.grasps = grasp_directory();
  return config;
}

void read_shard(const std::string& text, BuildJob& job) {
  const char* const end = text.data() + text.size();
  const auto [slash, fault] = std::from_chars(text.data(), end, job.shard);
  const bool has_slash = fault == std::errc() && slash != end && *slash == '/';
  const char* const second = has_slash ? slash + 1 : end;
  const auto [last, second_fault] = std::from_chars(second, end, job.shards);
  if (second_fault != std::errc() || last != end || job.shard < 0 || job.shard >= job.shards) {
    throw Error({.key = "--shard", .expected = "i/n with 0 <= i < n", .found = text});
  }
}

BuildJob job_of(const BuildArguments& options) {
  BuildJob job{.out = options.out, .work = options.work, .threads = options.threads};
  read_shard(options.shard, job);
  job.progress = console_progress("made", "rows");
  job.stop = interrupted;
  return job;
}

void print_json(const BuildReport& report) {
  const double rate = static_cast<double>(report.rendered_rows) / report.seconds;
  fmt::print("{}\n", nlohmann::json{{"rows", report.rows},
                                    {"rendered_rows", report.rendered_rows},
                                    {"seconds", report.seconds},
                                    {"rows_per_second", rate},
                                    {"bytes", report.bytes},
                                    {"content_hash", report.content_hash}}
                         .dump());
}

void print_text(const BuildArguments& options, const BuildReport& report) {
  if (report.content_hash.empty()) {
    fmt::print("part {} of the shards: {} rows, {} of them rendered, in {:.1f} s\n", options.shard,
               report.rows, report.rendered_rows, report.seconds);
    return;
  }
  fmt::print(
      "{}: {} rows, {} of them rendered, {:.1f} MB, in {:.1f} s ({:.0f} rows/s), content {}\n",
      options.out, report.rows, report.rendered_rows, static_cast<double>(report.bytes) / 1e6,
      report.seconds, static_cast<double>(report.rendered_rows) / report.seconds,
      report.content_hash);
}

void print(const BuildArguments& options, const BuildReport& report) {
  if (options.json) {
    print_json(report);
  } else {
    print_text(options, report);
  }
}

void run_build(const BuildArguments& options) {
  stop_on_interrupt();
  print(options, build_database(config_of(options), job_of(options)));
}

void add_job(CLI::App& verb, BuildArguments& options) {
  verb.add_option("--threads", options.threads, "Threads, 0 for all processors; changes no byte")
      ->check(range(0, 1024));
  verb.add_flag("--json", options.json, "The report as JSON");
}

// Registers options for the rows; each stands over the one of --config when it is given.
class RowOptions {
 public:
  RowOptions(CLI::App& verb, BuildArguments& options) : verb_(verb), options_(options) {}

  void add_all() {
    const CLI::Option* hands =
        add("--hand", &BuildConfig::hands,
            "A rigged hand with its rig map beside it; once for each [the male hand]")
            ->allow_extra_args(false);
    forget(hands, &BuildConfig::hand_hashes);
    const CLI::Option* grasps =
        add("--grasps", &BuildConfig::grasps, "The folder of grasp files [the project's own]");
    forget(grasps, &BuildConfig::grasp_hashes);
    add("--only", &BuildConfig::only, "Grasp numbers, by commas [all]")
        ->check(range(1, kLargestGrasp))
        ->delimiter(',')
        ->allow_extra_args(false);
    add("--objects", &BuildConfig::objects,
        "held: the object hides what it hides; free: the same poses without it; both")
        ->transform(named<Objects>(
            {{"held", Objects::kHeld}, {"free", Objects::kFree}, {"both", Objects::kBoth}}))
        ->default_str("held");
    add("--steps", &BuildConfig::steps, "Steps from rest to the closed hand")->check(range(1, 20));
    add("--views", &BuildConfig::views, "Orientations, evenly over all rotations")
        ->check(range(1, 100000));
    add("--resolution", &BuildConfig::resolution, "Side of a picture, pixels")
        ->check(range(16, 1024));
    add("--distance", &BuildConfig::distance, "From the camera to the palm, metres")
        ->check(range(0.2, 5.0));
    add("--renderer", &BuildConfig::renderer,
        "raster draws triangles, embree casts rays: the same pictures, raster faster")
        ->transform(named<RowRenderer>(
            {{"raster", RowRenderer::kRaster}, {"embree", RowRenderer::kEmbree}}))
        ->default_str("raster");
    add_descriptor();
    add_forearm();
    add_hog();
    add_jitters();
  }

 private:
  template <typename T>
  void add_jitter(const char* name, T Jitter::*member, const char* text, T low, T high) {
    Jitter& given = options_.given.jitter;
    CLI::Option* option =
        verb_.add_option(name, given.*member, text)->check(range(low, high))->group("Jitter");
    options_.override.emplace_back([option, member, &given](BuildConfig& config) {
      if (option->count() > 0) config.jitter.*member = given.*member;
    });
  }

  void add_jitters() {
    add_jitter("--jitter-angles", &Jitter::angles_deg,
               "Joint angles of the digits, up to so many degrees either way", 0.0, 30.0);
    add_jitter("--jitter-wrist", &Jitter::wrist_deg, "Wrist flexion and deviation, degrees", 0.0,
               30.0);
    add_jitter("--jitter-object-size", &Jitter::object_size_percent,
               "The object's size, percent; closes the hand on it again", 0.0, 30.0);
    add_jitter("--jitter-forearm", &Jitter::visible_forearm_mm, "Visible forearm, mm", 0.0, 200.0);
    add_jitter("--jitter-light", &Jitter::light_deg,
               "The light's direction, degrees, another one each view", 0.0, 90.0);
    add_jitter("--jitter-seed", &Jitter::seed, "Of all that is drawn", 0,
               std::numeric_limits<int>::max());
    add_jitter("--jitter-copies", &Jitter::copies,
               "Differently drawn copies: variants held, held 2, ...", 1, 100);
  }

  template <typename T>
  CLI::Option* add(const char* name, T BuildConfig::*member, const char* text) {
    CLI::Option* option = verb_.add_option(name, options_.given.*member, text);
    options_.override.emplace_back([option, member, &given = options_.given](BuildConfig& config) {
      if (option->count() > 0) config.*member = given.*member;
    });
    return option;
  }

  // A configuration's hashes are of its own files, not of those that an option puts in their place.
  template <typename T>
  void forget(const CLI::Option* option, T BuildConfig::*hashes) {
    options_.override.emplace_back([option, hashes](BuildConfig& config) {
      if (option->count() > 0) (config.*hashes).clear();
    });
  }

  void add_descriptor() {
    const CLI::Option* option =
        add("--descriptor", &BuildConfig::descriptor,
            "A file of weights: rows have the codes of this learned descriptor, too; or none");
    forget(option, &BuildConfig::descriptor_hash);
    options_.override.emplace_back([](BuildConfig& config) {
      if (config.descriptor == "none") config.descriptor.clear();
    });
  }

  void add_forearm() {
    CLI::Option* option = verb_
                              .add_option("--forearm", options_.visible_forearm_mm,
                                          "Visible forearm beyond the wrist, mm")
                              ->check(range(0.0, 300.0));
    options_.override.emplace_back(
        [option, &mm = options_.visible_forearm_mm](BuildConfig& config) {
          if (option->count() > 0) config.visible_forearm = mm / 1000;
        });
  }

  void add_hog() {
    CLI::Option* option = verb_.add_option("--hog", options_.hog, "The descriptor's mode")
                              ->check(one_of({"paper", "soft-edges"}));
    options_.override.emplace_back([option, &hog = options_.hog](BuildConfig& config) {
      if (option->count() > 0) config.hog = hog_from_name(hog, "--hog");
    });
  }

  CLI::App& verb_;
  BuildArguments& options_;
};

}  // namespace

void add_build(CLI::App& app) {
  auto options = std::make_shared<BuildArguments>();
  CLI::App* verb =
      app.add_subcommand("build", "Render a database of views of hands holding objects");
  verb->add_option("--out", options->out, "The database file to write")
      ->required()
      ->check(output_file());
  CLI::Option* preset =
      verb->add_option("--preset", options->preset,
                       "paper: the paper's 106,920 rows; tracking: what `track` works best with");
  preset->default_str("paper");
  verb->add_option("--config", options->config_file,
                   "A TOML file of options, or a database that is to be made again")
      ->excludes(preset);
  RowOptions(*verb, *options).add_all();
  verb->add_option("--work", options->work, "The folder of finished shards [OUT.work]")
      ->check(output_folder());
  verb->add_option("--shard", options->shard,
                   "i/n: make only the shards i, i + n, i + 2 n ...; `graspdb merge` joins them");
  add_job(*verb, *options);
  verb->footer(
      "What is finished stays in the folder of shards: a build that was stopped goes on, and one\n"
      "with another grasp renders only that.\n"
      "A preset is a file like that of --config: assets/presets/NAME.toml among the data.\n"
      "Example: graspdb build --preset tracking --out hands.graspdb");
  verb->callback([options] { run_build(*options); });
}

void add_merge(CLI::App& app) {
  auto options = std::make_shared<BuildArguments>();
  CLI::App* verb = app.add_subcommand("merge", "Join the shards of `graspdb build --shard`");
  verb->add_option("--out", options->out, "The database file to write")
      ->required()
      ->check(output_file());
  verb->add_option("--work", options->work, "The folder of finished shards [OUT.work]")
      ->check(output_folder());
  add_job(*verb, *options);
  verb->callback([options] {
    stop_on_interrupt();
    print(*options, merge_shards(job_of(*options)));
  });
}

}  // namespace graspdb::cli
