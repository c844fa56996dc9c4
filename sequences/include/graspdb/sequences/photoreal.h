// SPDX-License-Identifier: MIT
// Frames of a sequence that another renderer made as photographs (docs/sequences.md); the truth is
// the sequence's.
#pragma once

#include <filesystem>
#include <vector>

#include "graspdb/features/hand_finder.h"
#include "graspdb/sequences/frames.h"

namespace graspdb {

// Whether `folder` has a subfolder of the sequence's name. Throws Error when the pictures in it
// (000000.jpg, 000001.jpg ...) are not as many as the sequence has frames.
bool has_photoreal_frames(const SequenceSpec& spec, const std::filesystem::path& folder);

// Those that have a subfolder. Throws Error when none has one, and as above.
std::vector<SequenceSpec> with_photoreal_frames(std::vector<SequenceSpec> specs,
                                                const std::filesystem::path& folder);

// kPhotoreal: the hand is found as in a camera's frames, by a HandFollower.
// kPhotorealTrueMasks: the masks are the sequence's. Throws Error for a picture that is missing or
// not of the camera's size.
SequenceFrames photoreal_frames(const SequenceRenderer& sequence,
                                const std::filesystem::path& folder,
                                FrameKind kind = FrameKind::kPhotoreal,
                                const FinderOptions& finder = {});

}  // namespace graspdb
