// SPDX-License-Identifier: MIT
#include "crop_frame.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/samples/samples.h"
#include "graspdb/sequences/frames.h"
#include "graspdb/sequences/photoreal.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

// As the tracker would describe the frame, had it found the true mask.
std::optional<Sample> frame_sample(const SequenceFrames& frames, std::size_t frame, double length) {
  const Mask mask = isolate_hand(frames.hand[frame]);
  const auto square = crop_square(mask);
  if (!square) return std::nullopt;
  const FrameTruth& truth = frames.truth[frame];
  const Eigen::Matrix3d turn = crop_from_camera(frames.camera, *square);
  Keypoints joints = truth.joints;
  joints.colwise() -= palm_center(truth.joints);
  return Sample{.crop = crop_hand(frames.gray[frame], mask, *square),
                .crop_from_hand = turn * truth.camera_from_hand.rotation,
                .angles = truth.angles,
                .joints = turn * joints,
                .hand_length = length,
                .grasp = frames.grasp_type.value_or(0),
                .held = true,
                .hidden = frames.occlusion[frame]};
}

std::vector<SequenceSpec> specs_of(const fs::path& folder, const fs::path& photoreal) {
  std::vector<SequenceSpec> specs;
  for (const fs::path& file : sequence_files(folder)) specs.push_back(load_sequence(file));
  return photoreal.empty() ? specs : with_photoreal_frames(std::move(specs), photoreal);
}

SequenceFrames frames_of(const SequenceRenderer& renderer, const fs::path& photoreal) {
  if (photoreal.empty()) return render_frames(renderer);
  return photoreal_frames(renderer, photoreal, FrameKind::kPhotorealTrueMasks);
}

void add_frames(SequenceSamples& result, const SequenceFrames& frames, double length) {
  for (std::size_t i = 0; i < frames.gray.size(); ++i) {
    std::optional<Sample> sample = frame_sample(frames, i, length);
    if (!sample) continue;
    sample->sequence = static_cast<std::uint32_t>(result.names.size());
    result.samples.push_back(std::move(*sample));
  }
  result.names.push_back(frames.name);
}

}  // namespace

SequenceSamples sequence_samples(const fs::path& folder, const fs::path& photoreal,
                                 const Progress& progress) {
  const std::vector<SequenceSpec> specs = specs_of(folder, photoreal);
  SequenceSamples result;
  for (const SequenceSpec& spec : specs) {
    const SequenceRenderer renderer(spec);
    add_frames(result, frames_of(renderer, photoreal), hand_length(renderer.hand().skeleton));
    if (progress) progress(result.names.size(), specs.size());
  }
  return result;
}

}  // namespace graspdb
