// SPDX-License-Identifier: MIT
// How the hand is found in colour frames: what `track` and `find` share.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/video/frame_source.h"

namespace graspdb::cli {

struct FinderSettings {
  std::vector<int> roi;  // x, y, width, height; empty: none
  SkinOptions skin;

  std::optional<Box> box() const;
};

void add_finder_options(CLI::App& verb, FinderSettings& settings);

// Throws Error, with what the source says of itself, when it had no frames.
void require_frames(const FrameSource& source, const std::string& input, std::size_t frames);

// What a check of one option cannot see. Throws CLI::ValidationError.
void check(const FinderSettings& settings);

}  // namespace graspdb::cli
