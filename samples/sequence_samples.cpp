// SPDX-License-Identifier: MIT
#include "crop_frame.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/samples/samples.h"
#include "graspdb/sequences/frames.h"

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

}  // namespace

SequenceSamples sequence_samples(const fs::path& folder, const Progress& progress) {
  const std::vector<fs::path> files = sequence_files(folder);
  SequenceSamples result;
  for (const fs::path& file : files) {
    const SequenceRenderer renderer(load_sequence(file));
    const SequenceFrames frames = render_frames(renderer);
    const double length = hand_length(renderer.hand().skeleton);
    for (std::size_t i = 0; i < frames.gray.size(); ++i) {
      std::optional<Sample> sample = frame_sample(frames, i, length);
      if (!sample) continue;
      sample->sequence = static_cast<std::uint32_t>(result.names.size());
      result.samples.push_back(std::move(*sample));
    }
    result.names.push_back(frames.name);
    if (progress) progress(result.names.size(), files.size());
  }
  return result;
}

}  // namespace graspdb
