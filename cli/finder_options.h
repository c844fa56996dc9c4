// SPDX-License-Identifier: MIT
// How the hand is found in colour frames: the options that `track` and `find` share.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/features/segmentation.h"

namespace graspdb::cli {

struct FinderSettings {
  std::vector<int> roi;  // x, y, width, height; empty: none
  SkinOptions skin;

  std::optional<Box> box() const;
};

void add_finder_options(CLI::App& verb, FinderSettings& settings);

// What a check of one option cannot see. Throws CLI::ValidationError.
void check(const FinderSettings& settings);

}  // namespace graspdb::cli
