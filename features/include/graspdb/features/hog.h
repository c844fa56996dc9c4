// SPDX-License-Identifier: MIT
// The descriptor of a hand's picture. The same code describes a rendered view and a camera frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graspdb/core/descriptor.h"
#include "graspdb/core/image.h"

namespace graspdb {

// The smallest box that holds every non-zero pixel; none for an empty mask.
std::optional<Box> tight_box(const Mask& mask);

enum class HogMode {
  // As Romero et al. (ICRA 2010): the box is cut into 8 x 8 cells (the last ones take the
  // remainder); every hand pixel whose 3 x 3 neighbourhood is not flat votes 1 for the orientation
  // of its Sobel gradient; each cell is L1-normalised times its share of hand pixels.
  kPaper,
  // For pictures of unlike size, light and noise: the box is averaged down (or spread) to 64 x 64
  // pixels; the outline votes with its contrast, 1, whatever the light, and inner edges with theirs
  // relative to the hand's mean brightness, without the faint ones and with no more than a part of
  // the outline's weight; votes are split between the two nearest orientations. A value is the
  // square root of a cell's votes, without normalisation.
  kSoftEdges,
};

// The name that is stored in a database ("paper", "soft-edges"), and back. Throws Error for an
// unknown one.
std::string hog_name(HogMode mode);
HogMode hog_from_name(std::string_view name, const std::string& file);

// Describes the mask's pixels inside its tight box; everything outside the mask counts as 0. An
// empty mask gives zeros. `gray` and `mask` are of one size. Pure and thread-safe.
Descriptor describe(const GrayImage& gray, const Mask& mask, HogMode mode);

}  // namespace graspdb
