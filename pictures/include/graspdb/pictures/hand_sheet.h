// SPDX-License-Identifier: MIT
// Pictures of hands.
#pragma once

#include "graspdb/core/image.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// The hand in five poses (rows) from four sides (columns).
ColorImage draw_hand_sheet(const Hand& hand);

// What each of the 28 angles means: the flat hand beside the hand with one angle at 20 degrees, or
// at its limit where that is less, from the side that shows it best.
ColorImage draw_angle_page(const Hand& hand);

}  // namespace graspdb
