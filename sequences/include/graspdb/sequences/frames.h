// SPDX-License-Identifier: MIT
// All frames of a sequence as the tracker is shown them, with what is true in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/sequences/finding.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {

// Where frames and masks come from: this project's renderer and the true mask, or photorealistic
// pictures (photoreal.h) and a mask found in them, or the true one. Their numbers are never mixed.
enum class FrameKind { kRendered, kPhotoreal, kPhotorealTrueMasks };
std::string kind_name(FrameKind kind);  // "rendered", "photoreal", "photoreal-true-masks"

// What the tracker is shown of one sequence and what it is held against.
struct SequenceFrames {
  std::string name;
  std::optional<int> grasp_type;  // Feix's number, if the grasp is one of them
  Intrinsics camera;
  std::vector<GrayImage> gray;  // a frame each, as all that follow
  std::vector<Mask> hand;       // visible; noise is added by evaluate()
  std::vector<FrameTruth> truth;
  std::vector<double> occlusion;
  FrameKind kind = FrameKind::kRendered;
  // Found apart from the hand, of which nothing is to be cut off then; else empty.
  std::vector<Mask> arm;
  std::vector<Finding> found;  // how well; none for true masks
};
SequenceFrames render_frames(const SequenceRenderer& sequence);

}  // namespace graspdb
