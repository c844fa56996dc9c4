// SPDX-License-Identifier: MIT
#include "graspdb/sequences/photoreal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/renderer/image_io.h"

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

struct Found {
  Mask shown;  // to evaluate()
  Mask hand;
};

Found found_by_color(const ColorImage& color, const SkinOptions& options) {
  const Mask nothing(color.width(), color.height());
  const Mask region = find_region(color, {}, options).value_or(nothing);
  const Mask hand = isolate_hand(region);
  return {is_empty(hand) ? nothing : region, hand};
}

Found found_in(const ColorImage& color, const FinderOptions& finder) {
  if (!finder.net) return found_by_color(color, finder.skin);
  const Mask hand = find_hand(color, {}, finder);
  return {hand, hand};
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
  const bool find = kind == FrameKind::kPhotoreal;
  if (find) frames.segmentation_iou.resize(frames.hand.size());
  frames.ends_at_wrist = find && finder.net;
  parallel_for(frames.hand.size(), 0, [&](std::size_t i) {
    const fs::path file = folder / frames.name / fmt::format("{:06}.jpg", i);
    const ColorImage color = read_frame(file, frames.camera);
    frames.gray[i] = to_gray(color);
    if (!find) return;
    Found found = found_in(color, finder);
    frames.segmentation_iou[i] = mask_iou(found.hand, isolate_hand(frames.hand[i]));
    frames.hand[i] = std::move(found.shown);
  });
  return frames;
}

double mask_iou(const Mask& a, const Mask& b) {
  GRASPDB_CHECK(a.width() == b.width() && a.height() == b.height());
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += a.data()[i] != 0 && b.data()[i] != 0;
    either += a.data()[i] != 0 || b.data()[i] != 0;
  }
  return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : std::nan("");
}

}  // namespace graspdb
