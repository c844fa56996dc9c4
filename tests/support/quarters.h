// SPDX-License-Identifier: MIT
// Pictures of four quarters, each of one colour, that tell how they were turned.
#pragma once

#include <string>

#include "graspdb/core/image.h"

namespace graspdb::testing {

// r, g, b and w of the corners: upper left, upper right, lower left, lower right.
inline std::string corners_of(const ColorImage& image) {
  std::string corners;
  for (const int y : {2, image.height() - 3}) {
    for (const int x : {2, image.width() - 3}) {
      const Bgr& pixel = image.at(x, y);
      const bool blue = pixel[0] > 127, green = pixel[1] > 127;
      corners += blue && green ? 'w' : blue ? 'b' : green ? 'g' : 'r';
    }
  }
  return corners;
}

}  // namespace graspdb::testing
