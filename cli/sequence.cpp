// SPDX-License-Identifier: MIT
#include "graspdb/sequence.h"

#include <fmt/format.h>

#include "console.h"
#include "verbs.h"

namespace graspdb::cli {

void add_sequence(CLI::App& app) {
  struct Options {
    std::string file, out, hand;
    NoiseOptions noise;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("sequence", "Render an evaluation sequence with ground truth");
  verb->add_option("SEQ", options->file, "The sequence's .toml file")->required();
  verb->add_option("--out", options->out, "The folder for frames, masks, noisy masks and truth")
      ->required();
  verb->add_option("--hand", options->hand, "A rigged hand instead of the sequence's own");
  verb->add_option("--alpha", options->noise.alpha_percent,
                   "Segmentation noise: dropped hand pixels, percent")
      ->check(CLI::Range(0.0, 100.0));
  verb->add_option("--seed", options->noise.seed, "Seed of the segmentation noise");
  verb->footer("Example: graspdb sequence sequences/test/bottle.toml --alpha 0.5 --out bottle");
  verb->callback([options] {
    const SequenceRenderer renderer(load_sequence(options->file, options->hand));
    write_sequence(renderer, options->out, options->noise, console_progress("rendered", "frames"));
    fmt::print("{}: {} frames\n", options->out, renderer.spec().frame_count());
  });
}

}  // namespace graspdb::cli
