// SPDX-License-Identifier: MIT
#include "graspdb/sequences/sequence.h"

#include <fmt/format.h>

#include "checks.h"
#include "console.h"
#include "graspdb/grasps/closing.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct SequenceArguments {
  std::string file, out, meshes, hand;
  std::optional<double> fps;
  SequenceNoise noise;
  bool close = false;
};

SequenceSpec load(const SequenceArguments& options) {
  SequenceSpec spec = load_sequence(options.file, options.hand);
  if (options.fps) spec.frames_per_second = *options.fps;
  return spec;
}

void keep_closed(const SequenceSpec& spec) {
  const Hand hand = sequence_hand(spec);
  const auto file = keep_closed_poses({spec.grasp}, hand, {close_grasp(spec.grasp, hand)});
  fmt::print("{}\n", file.string());
}

}  // namespace

void add_sequence(CLI::App& app) {
  auto options = std::make_shared<SequenceArguments>();
  CLI::App* verb =
      app.add_subcommand("sequence", "Render an evaluation sequence with ground truth");
  verb->add_option("SEQ", options->file, "The sequence's .toml file")->required();
  CLI::Option* out =
      verb->add_option("--out", options->out, "The folder for frames, masks, noisy masks and truth")
          ->check(output_folder());
  CLI::Option* meshes =
      verb->add_option("--meshes", options->meshes,
                       "A folder for hand, object and camera of every frame, for other renderers")
          ->check(output_folder());
  CLI::Option* close =
      verb->add_flag("--close", options->close,
                     "Close the hand on the object anew and keep the pose beside the grasp file");
  verb->add_option("--hand", options->hand, "A rigged hand instead of the sequence's own");
  verb->add_option("--fps", options->fps, "Frames a second instead of the file's")
      ->check(range(kMinFramesPerSecond, kMaxFramesPerSecond));
  verb->add_option("--alpha", options->noise.alpha_percent,
                   "Segmentation noise: dropped hand pixels, percent")
      ->check(range(0.0, 100.0));
  verb->add_option("--seed", options->noise.seed, "Seed of the segmentation noise")
      ->check(natural());
  verb->footer("Example: graspdb sequence sequences/test/bottle.seq.toml --alpha 0.5 --out bottle");
  verb->callback([options, out, meshes, close] {
    if (out->count() + meshes->count() + close->count() == 0)
      throw CLI::RequiredError("--out, --meshes or --close");
    if (options->close) keep_closed(load(*options));
    if (options->out.empty() && options->meshes.empty()) return;
    const SequenceRenderer renderer(load(*options));
    if (!options->meshes.empty()) write_meshes(mesh_frames(renderer), options->meshes);
    if (options->out.empty()) return;
    write_sequence(renderer, options->out, options->noise, console_progress("rendered", "frames"));
    fmt::print("{}: {} frames\n", options->out, renderer.spec().frame_count());
  });
}

}  // namespace graspdb::cli
