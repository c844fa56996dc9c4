// SPDX-License-Identifier: MIT
// From the pixels that a file stores to the picture that a viewer shows: upright, of square pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "graspdb/core/image.h"

namespace graspdb {

struct PixelLayout {
  int orientation = 1;  // as EXIF numbers them: 1 upright, 3 upside down, 6 to be turned clockwise
  double aspect = 1;    // a stored pixel's width over its height
  bool operator==(const PixelLayout&) const = default;
};

// What a file states, cleaned: an orientation that is none is 1, an aspect that is none (0, NaN) or
// within 1 % of square is 1. Throws Error naming the file for pixels over 4 times as long as wide.
PixelLayout checked_layout(int orientation, double aspect, const std::string& file);

// The picture as a viewer shows it. To make pixels square it grows along one side, by
// interpolation of colours, by the nearest pixel of levels.
ColorImage as_shown(ColorImage stored, const PixelLayout& layout);
Image<std::uint16_t> as_shown(Image<std::uint16_t> stored, const PixelLayout& layout);

// What as_shown() does, a sentence each: "turned clockwise by 90 degrees (EXIF orientation 6)".
// `source` is what states the orientation.
std::vector<std::string> notes_on(const PixelLayout& layout, const std::string& source);

}  // namespace graspdb
