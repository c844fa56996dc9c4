// SPDX-License-Identifier: MIT
#include "sequence_set.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "checks.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/sequences/photoreal.h"
#include "graspdb/tracker/hand_reader.h"

namespace graspdb::cli {
namespace {

void require_hand(const SequenceSpec& spec) {
  const auto& hand = spec.hand.file;
  if (hand.empty() || std::filesystem::exists(hand)) return;
  throw Error({spec.file.string(), "hand.file", "a hand; scripts/fetch_hands.sh fetches WebXR's",
               "no file " + hand.string()});
}

std::vector<SequenceSpec> load_all(const SequenceSetOptions& options) {
  if (!options.hand.empty()) load_hand(options.hand);
  std::vector<SequenceSpec> specs;
  std::set<std::string> names;
  for (const auto& file : sequence_files(options.sequences)) {
    specs.push_back(load_sequence(file, options.hand));
    if (options.fps) specs.back().frames_per_second = *options.fps;
    require_hand(specs.back());
    if (names.insert(specs.back().name).second) continue;
    throw Error({file.string(), "name", "one that no other sequence has", specs.back().name});
  }
  return specs;
}

}  // namespace

SequenceSet::SequenceSet(SequenceSetOptions options)
    : options_(std::move(options)),
      finder_(options_.finder.options(!options_.photoreal.empty() && !options_.true_masks)),
      specs_(load_all(options_)) {
  if (!options_.photoreal.empty()) {
    specs_ = with_photoreal_frames(std::move(specs_), options_.photoreal);
  }
}

std::optional<SequenceRenderer> SequenceSet::leave_out(const std::string& name,
                                                       const std::string& why) {
  fmt::print(stderr, "{} is left out: {}\n", name, why);
  left_out_.emplace_back(name, why);
  return std::nullopt;
}

std::optional<SequenceRenderer> SequenceSet::renderer(const SequenceSpec& own) {
  if (options_.hand.empty() && options_.grasps.empty()) return SequenceRenderer(own);
  std::optional<SequenceSpec> spec = own;
  if (!options_.grasps.empty()) spec = with_grasp_of_type(own, options_.grasps);
  if (!spec) return leave_out(own.name, "no grasp of its type in " + options_.grasps);
  // Nobody has looked at what the two options put together: a hand that cannot be closed on the
  // object leaves out this sequence, not all of them.
  try {
    return SequenceRenderer(std::move(*spec));
  } catch (const Error& error) {
    return leave_out(own.name, error.what());
  }
}

void SequenceSet::choose_hands_by(const Database& database, const Search& search) {
  if (finder_.net) finder_.unlikeness = unlikeness_to(database, search, Handedness::kRight);
}

SequenceFrames SequenceSet::frames(const SequenceRenderer& renderer) const {
  if (options_.photoreal.empty()) return render_frames(renderer);
  const FrameKind kind =
      options_.true_masks ? FrameKind::kPhotorealTrueMasks : FrameKind::kPhotoreal;
  return photoreal_frames(renderer, options_.photoreal, kind, finder_);
}

// Null when no hand is found.
nlohmann::json SequenceSet::finder_json() const {
  if (options_.photoreal.empty() || options_.true_masks) return {};
  if (!finder_.net) return {{"name", options_.finder.finder}};
  return {{"name", options_.finder.finder}, {"weights", finder_.net->hash()}};
}

nlohmann::json SequenceSet::json() const {
  nlohmann::json left_out = nlohmann::json::array();
  for (const auto& [name, why] : left_out_) left_out.push_back({{"sequence", name}, {"why", why}});
  return {{"fps", options_.fps ? nlohmann::json(*options_.fps) : nlohmann::json()},
          {"finder", finder_json()},
          {"hand", options_.hand},
          {"grasps", options_.grasps},
          {"left_out", std::move(left_out)}};
}

void add_sequence_options(CLI::App& verb, SequenceSetOptions& options) {
  verb.add_option("--sequences", options.sequences, "A folder of *.seq.toml, or one of them")
      ->required();
  CLI::Option* photoreal =
      verb.add_option("--photoreal", options.photoreal,
                      "A folder of photoreal frames, NAME/000000.jpg ...: only sequences that have "
                      "them are run, on them, with the hand that is found");
  verb.add_flag("--true-masks", options.true_masks,
                "Photoreal frames are shown with the hand's true mask instead")
      ->needs(photoreal);
  add_finder_option(verb, options.finder)->needs(photoreal);
  CLI::Option* hand =
      verb.add_option("--hand", options.hand, "A rigged hand instead of the sequences' own");
  CLI::Option* grasps = verb.add_option(
      "--grasps", options.grasps,
      "A folder of grasps: the one of a sequence's type, with its object, instead of "
      "the sequence's own; a sequence without a type is left out");
  CLI::Option* fps = verb.add_option("--fps", options.fps, "Frames a second instead of the files'")
                         ->check(range(kMinFramesPerSecond, kMaxFramesPerSecond));
  photoreal->excludes(hand)->excludes(grasps)->excludes(fps);  // photographs show what they show
}

void add_noise_options(CLI::App& verb, NoiseOptions& options) {
  verb.add_option("--alphas", options.alphas, "Segmentation noise, percent, by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(range(0.0, 100.0));
  verb.add_option("--seed", options.seed, "Seed of the segmentation noise")->check(natural());
}

}  // namespace graspdb::cli
