// SPDX-License-Identifier: MIT
// The sequences that `eval` and `tune` run the tracker over, and the noise that they add.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "finder_options.h"
#include "graspdb/evaluation/evaluate.h"

namespace graspdb::cli {

struct SequenceSetOptions {
  std::string sequences;     // a folder of *.seq.toml, or one of them
  std::string photoreal;     // a folder of frames; empty: they are rendered
  bool true_masks = false;   // of photoreal frames, instead of those found
  FinderSettings finder;     // of hands in photoreal frames
  std::string hand, grasps;  // instead of the sequences' own, unless empty
  std::optional<double> fps;
};
void add_sequence_options(CLI::App& verb, SequenceSetOptions& options);

struct NoiseOptions {          // of the segmentation
  std::vector<double> alphas;  // percent
  std::uint64_t seed = 0;
};
void add_noise_options(CLI::App& verb, NoiseOptions& options);

// What is wrong with any of the files is found before the first is run.
class SequenceSet {
 public:
  explicit SequenceSet(SequenceSetOptions options);

  const std::vector<SequenceSpec>& specs() const { return specs_; }
  // Where a learned finder is used, between its hand and that of its colour (FinderOptions). The
  // search must outlive it.
  void choose_hands_by(const Database& database, const Search& search);

  // Nothing when --hand or --grasps leave it out: no grasp of its type, or a hand that cannot be
  // closed on its object. Told on stderr.
  std::optional<SequenceRenderer> renderer(const SequenceSpec& spec);
  SequenceFrames frames(const SequenceRenderer& renderer) const;

  // finder: {name, weights}, null when masks are true ones; fps, hand and grasps as they were
  // given; left_out: [{sequence, why}].
  nlohmann::json json() const;

 private:
  nlohmann::json finder_json() const;
  std::optional<SequenceRenderer> leave_out(const std::string& name, const std::string& why);

  SequenceSetOptions options_;
  FinderOptions finder_;
  std::vector<SequenceSpec> specs_;
  std::vector<std::pair<std::string, std::string>> left_out_;  // name and why
};

}  // namespace graspdb::cli
