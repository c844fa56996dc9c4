// SPDX-License-Identifier: MIT
// How the hand is found in colour frames: what `track`, `find`, `eval` and `tune` share.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/features/hand_finder.h"
#include "graspdb/video/frame_source.h"

namespace graspdb::cli {

struct FinderSettings {
  std::string finder = "hand";
  std::vector<int> roi;  // x, y, width, height; empty: none

  // Reads the net's file, but not where no hand is looked for, as all masks are given. Throws Error
  // for one that cannot be read.
  FinderOptions options(bool looks_for_hands = true) const;
  std::optional<Box> box() const;
};

CLI::Option* add_finder_option(CLI::App& verb, FinderSettings& settings);
void add_still_option(CLI::App& verb, bool& still);
void add_roi_option(CLI::App& verb, FinderSettings& settings);

// Throws Error, with what the source says of itself, when it had no frames.
void require_frames(const FrameSource& source, const std::string& input, std::size_t frames);

// What a check of one option cannot see. Throws CLI::ValidationError.
void check(const FinderSettings& settings);

}  // namespace graspdb::cli
