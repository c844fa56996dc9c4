// SPDX-License-Identifier: MIT
// The descriptor of a hand's picture. The same code describes a rendered view and a camera frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graspdb/descriptor.h"
#include "graspdb/image.h"

namespace graspdb {

// The smallest box that holds every non-zero pixel; none for an empty mask.
std::optional<Box> tight_box(const Mask& mask);

enum class HogMode {
  kPaper,  // count votes on Sobel gradients; each cell L1-normalised times its share of hand pixels
};

struct HogOptions {
  HogMode mode = HogMode::kPaper;
};

// The name that is stored in a database, and back. Throws Error for an unknown one.
std::string hog_name(const HogOptions& options);
HogOptions hog_from_name(std::string_view name, const std::string& file);

// Describes the mask's pixels inside its tight box; everything outside the mask counts as 0. An
// empty mask gives zeros. `gray` and `mask` are of one size. Pure and thread-safe.
Descriptor describe(const GrayImage& gray, const Mask& mask, const HogOptions& options = {});

}  // namespace graspdb
