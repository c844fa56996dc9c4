// SPDX-License-Identifier: MIT
// Training pictures: crops of drawn hands in drawn poses, with their labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graspdb/core/progress.h"
#include "graspdb/features/crop.h"
#include "graspdb/features/embedding.h"
#include "graspdb/features/hog.h"
#include "graspdb/hand/angles.h"
#include "graspdb/hand/skeleton.h"
#include "graspdb/samples/sample_config.h"

namespace graspdb {

// A crop and what is true of the hand in it. The crop's frame is that of a camera that looks at the
// crop's middle: the picture's own, turned by the smallest rotation that takes its axis there. So
// the label says nothing of where in the frame the hand was.
struct Sample {
  HandCrop crop;
  Eigen::Matrix3d crop_from_hand = Eigen::Matrix3d::Identity();  // rotation
  JointAngles angles = JointAngles::Zero();
  Keypoints joints = Keypoints::Zero();  // crop frame, from the palm centre, metres
  double hand_length = 0;                // metres
  std::uint64_t hand = 0;                // samples of one hand have one number
  int grasp = 0;                         // id; 0 of a free hand
  bool held = false;                     // is an object in the hand
  double hidden = 0;                     // share of the hand that its object hides; of sequences
  std::uint32_t sequence = 0;            // of sequences: ordinal among those of the file
  std::optional<Descriptor> hog;         // until describe_samples()
  Embedding embedding;                   // empty until describe_samples()
};

// A file that samples were made from.
struct SampleAsset {
  std::string name;  // of a hand or a grasp
  std::string hash;
};

// Draws samples: each is a pure function of the configuration and its number. Thread-safe.
class SampleMaker {
 public:
  // Throws Error for bad input. Closed poses that are not committed take a second each.
  explicit SampleMaker(const SampleConfig& config, int threads = 0);
  ~SampleMaker();

  // The samples `first`, `first + 1`, ... `threads` as in parallel_for.
  void make(std::uint64_t first, std::span<Sample> samples, int threads = 0,
            const Progress& progress = {}) const;
  const std::vector<SampleAsset>& assets() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The frames of evaluation sequences (*.seq.toml) of a folder as samples, with their true masks, in
// the order of their names. With a folder of photoreal frames (graspdb/sequences/photoreal.h): of
// the sequences that have such frames, these; throws Error when none has any.
struct SequenceSamples {
  std::vector<std::string> names;  // of sequences
  std::vector<Sample> samples;     // frames that show no hand are left out
};
SequenceSamples sequence_samples(const std::filesystem::path& folder,
                                 const std::filesystem::path& photoreal = {},
                                 const Progress& progress = {});

// Gives each its code by this net.
void describe_samples(const EmbeddingNet& net, std::span<Sample> samples, int threads = 0);
// Gives each the HOG of its crop.
void describe_samples(HogMode mode, std::span<Sample> samples, int threads = 0);

// Writes a safetensors file, aside and renamed (docs/samples.md).
void write_samples(const std::filesystem::path& file, std::span<const Sample> samples,
                   const SampleConfig& config, std::uint64_t first,
                   std::span<const SampleAsset> assets);
void write_samples(const std::filesystem::path& file, const SequenceSamples& sequences);

}  // namespace graspdb
