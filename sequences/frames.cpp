// SPDX-License-Identifier: MIT
#include "graspdb/sequences/frames.h"

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {

SequenceFrames render_frames(const SequenceRenderer& sequence) {
  const SequenceSpec& spec = sequence.spec();
  const auto count = static_cast<std::size_t>(spec.frame_count());
  SequenceFrames frames{.name = spec.name, .grasp_type = spec.grasp_type, .camera = spec.camera};
  frames.gray.resize(count);
  frames.hand.resize(count);
  frames.truth.resize(count);
  frames.occlusion.resize(count);
  parallel_for(count, 0, [&](std::size_t i) {
    SequenceFrame rendered = sequence.render(static_cast<int>(i));
    frames.gray[i] = to_gray(rendered.color);
    frames.hand[i] = std::move(rendered.hand);
    frames.truth[i] = rendered.truth;
    frames.occlusion[i] = rendered.occlusion;
  });
  return frames;
}

std::string kind_name(FrameKind kind) {
  switch (kind) {
    case FrameKind::kRendered:
      return "rendered";
    case FrameKind::kPhotoreal:
      return "photoreal";
    case FrameKind::kPhotorealTrueMasks:
      return "photoreal-true-masks";
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
