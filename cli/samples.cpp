// SPDX-License-Identifier: MIT
#include "graspdb/samples/samples.h"

#include <fmt/format.h>

#include "checks.h"
#include "console.h"
#include "graspdb/core/error.h"
#include "graspdb/pictures/sample_sheet.h"
#include "graspdb/renderer/image_io.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

// A sample takes 13 kB of memory: a file is no larger than what a small machine holds.
constexpr int kMostSamples = 500'000;

struct SampleArguments {
  std::string out, sheet, config, sequences, photoreal, hog, descriptor;
  std::uint64_t first = 0;
  int count = 10'000, threads = 0;
};

void describe(const SampleArguments& options, std::span<Sample> samples) {
  if (!options.hog.empty()) {
    describe_samples(hog_from_name(options.hog, "--hog"), samples, options.threads);
  }
  if (!options.descriptor.empty()) {
    describe_samples(EmbeddingNet::load(options.descriptor), samples, options.threads);
  }
}

void write_sheet(const SampleArguments& options, std::span<const Sample> samples) {
  if (!options.sheet.empty()) write_png(options.sheet, draw_sample_sheet(samples));
}

void make_samples(const SampleArguments& options) {
  const SampleConfig config =
      options.config.empty() ? SampleConfig{} : load_sample_config(options.config);
  const SampleMaker maker(config, options.threads);
  std::vector<Sample> samples(static_cast<std::size_t>(options.count));
  maker.make(options.first, samples, options.threads, console_progress("drawn", "samples"));
  describe(options, samples);
  if (!options.out.empty()) {
    write_samples(options.out, samples, config, options.first, maker.assets());
  }
  write_sheet(options, samples);
}

void take_sequences(const SampleArguments& options) {
  SequenceSamples sequences =
      sequence_samples(options.sequences, options.photoreal, console_progress("read", "sequences"));
  describe(options, sequences.samples);
  if (!options.out.empty()) write_samples(options.out, sequences);
  write_sheet(options, sequences.samples);
  fmt::print("{} frames of {} sequences\n", sequences.samples.size(), sequences.names.size());
}

}  // namespace

void add_samples(CLI::App& app) {
  auto options = std::make_shared<SampleArguments>();
  CLI::App* verb =
      app.add_subcommand("samples", "Draw training pictures of hands, with their poses");
  CLI::Option* out =
      verb->add_option("--out", options->out, "The .safetensors file to write (docs/samples.md)")
          ->check(output_file({".safetensors"}));
  CLI::Option* sheet = verb->add_option("--sheet", options->sheet, "A picture of the first ones")
                           ->check(output_file({".png"}));
  CLI::Option* first =
      verb->add_option("--first", options->first, "Number of the first one")->check(natural());
  CLI::Option* count =
      verb->add_option("--count", options->count, "How many")->check(range(1, kMostSamples));
  CLI::Option* config = verb->add_option("--config", options->config, "A TOML file of options");
  CLI::Option* sequences =
      verb->add_option("--sequences", options->sequences,
                       "The frames of this folder's *.seq.toml instead, with their true masks")
          ->excludes(first)
          ->excludes(count)
          ->excludes(config);
  verb->add_option("--photoreal", options->photoreal,
                   "Of those that have frames in this folder, NAME/000000.jpg ..., these frames")
      ->needs(sequences);
  verb->add_option("--descriptor", options->descriptor,
                   "A file of weights: the samples have its codes, too");
  verb->add_option("--hog", options->hog, "The samples have the HOG of their crop, too")
      ->check(one_of({"paper", "soft-edges"}));
  verb->add_option("--threads", options->threads, "Threads, 0 for all processors; changes no byte")
      ->check(range(0, 1024));
  verb->footer(
      "A sample depends on its number and the options alone: parts that are drawn apart fit.\n"
      "Example: graspdb samples --count 20000 --out part0.safetensors --sheet part0.png");
  verb->callback([options, out, sheet] {
    if (out->count() + sheet->count() == 0) throw CLI::RequiredError("--out or --sheet");
    options->sequences.empty() ? make_samples(*options) : take_sequences(*options);
  });
}

}  // namespace graspdb::cli
