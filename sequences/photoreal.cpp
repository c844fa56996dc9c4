// SPDX-License-Identifier: MIT
#include "graspdb/sequences/photoreal.h"

#include <fmt/format.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/features/hand_follower.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/meshes.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

ColorImage read_frame(const fs::path& file, const Intrinsics& camera) {
  ColorImage color = read_color(file);
  if (color.width() == camera.width && color.height() == camera.height) return color;
  throw Error({file.string(), "",
               fmt::format("a picture of {} x {} pixels", camera.width, camera.height),
               fmt::format("{} x {}", color.width(), color.height())});
}

// The hand and 15 mm of its arm.
Mask true_hand(const MeshFrames& meshes, std::size_t frame) {
  const Image<std::uint8_t> labels = frame_labels(meshes, frame);
  Mask hand(labels.width(), labels.height());
  std::ranges::transform(labels, hand.begin(), [](std::uint8_t label) {
    return static_cast<std::uint8_t>(label == kLabelHand ? 255 : 0);
  });
  return hand;
}

// In place of the true masks.
void find_hands(SequenceFrames& frames, const std::vector<ColorImage>& colors,
                const FinderOptions& finder, const SequenceRenderer& sequence) {
  HandFollower follower(finder);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    FoundHand found = follower.next(colors[i]);
    frames.hand[i] = std::move(found.hand);
    frames.arm.push_back(std::move(found.arm));
  }
  const MeshFrames meshes = mesh_frames(sequence);
  frames.found.resize(colors.size());
  parallel_for(colors.size(), 0, [&](std::size_t i) {
    frames.found[i] = compare_masks(frames.hand[i], true_hand(meshes, i), frames.truth[i],
                                    sequence.hand().skeleton, frames.camera);
  });
}

}  // namespace

bool has_photoreal_frames(const SequenceSpec& spec, const fs::path& folder) {
  const fs::path frames = folder / spec.name;
  if (!fs::is_directory(frames)) return false;
  const auto found =
      std::count_if(fs::directory_iterator(frames), fs::directory_iterator(),
                    [](const auto& entry) { return entry.path().extension() == ".jpg"; });
  if (found == spec.frame_count()) return true;
  throw Error({frames.string(), "",
               fmt::format("{} pictures (.jpg), a frame of {} each", spec.frame_count(), spec.name),
               fmt::format("{}", found)});
}

std::vector<SequenceSpec> with_photoreal_frames(std::vector<SequenceSpec> specs,
                                                const fs::path& folder) {
  std::erase_if(specs, [&](const auto& spec) { return !has_photoreal_frames(spec, folder); });
  if (!specs.empty()) return specs;
  throw Error({.file = folder.string(),
               .expected = "a folder of frames with the name of a sequence",
               .found = "none"});
}

SequenceFrames photoreal_frames(const SequenceRenderer& sequence, const fs::path& folder,
                                FrameKind kind, const FinderOptions& finder) {
  GRASPDB_CHECK(kind != FrameKind::kRendered);
  SequenceFrames frames = render_frames(sequence);
  frames.kind = kind;
  std::vector<ColorImage> colors(frames.hand.size());
  parallel_for(colors.size(), 0, [&](std::size_t i) {
    const fs::path file = folder / frames.name / fmt::format("{:06}.jpg", i);
    colors[i] = read_frame(file, frames.camera);
    frames.gray[i] = to_gray(colors[i]);
  });
  if (kind == FrameKind::kPhotoreal) find_hands(frames, colors, finder, sequence);
  return frames;
}

}  // namespace graspdb
