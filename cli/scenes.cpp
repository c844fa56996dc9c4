// SPDX-License-Identifier: MIT
#include "graspdb/samples/scenes.h"

#include <fmt/format.h>

#include <mutex>

#include "checks.h"
#include "console.h"
#include "graspdb/core/parallel.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct SceneArguments {
  std::string out, config;
  SceneOptions scene;
  std::uint64_t first = 0;
  int count = 100, threads = 0;
};

void write_scenes(const SceneArguments& options) {
  const SampleConfig config =
      options.config.empty() ? SampleConfig{} : load_sample_config(options.config);
  const SceneMaker maker(config, options.scene, options.threads);
  const Progress progress = console_progress("drawn", "scenes");
  const auto count = static_cast<std::size_t>(options.count);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(count, options.threads, [&](std::size_t i) {
    const std::uint64_t number = options.first + i;
    write_meshes(maker.make(number),
                 std::filesystem::path(options.out) / fmt::format("{:06}", number));
    const std::lock_guard lock(mutex);
    progress(++done, count);
  });
}

}  // namespace

void add_scenes(CLI::App& app) {
  auto options = std::make_shared<SceneArguments>();
  CLI::App* verb = app.add_subcommand(
      "scenes", "Draw hands before a camera, as meshes with labels, for other renderers");
  verb->add_option("--out", options->out,
                   "The folder, which gets one for every scene (docs/scenes.md)")
      ->required()
      ->check(output_folder());
  verb->add_option("--first", options->first, "Number of the first one")->check(natural());
  verb->add_option("--count", options->count, "How many")->check(range(1, 100'000));
  verb->add_option("--frames", options->scene.frames, "Frames of each")->check(range(1, 1000));
  verb->add_option("--width", options->scene.width, "Of a picture, pixels")->check(range(16, 4096));
  verb->add_option("--height", options->scene.height, "Of a picture, pixels")
      ->check(range(16, 4096));
  verb->add_option("--config", options->config,
                   "A TOML file of options: what `samples` has for hands, poses and distances");
  verb->add_option("--threads", options->threads, "Threads, 0 for all processors; changes no byte")
      ->check(range(0, 1024));
  verb->footer(
      "A scene depends on its number and the options alone: parts that are drawn apart fit.\n"
      "Example: graspdb scenes --count 300 --out out/scenes");
  verb->callback([options] { write_scenes(*options); });
}

}  // namespace graspdb::cli
