// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/features/hand_finder.h"

namespace graspdb {

// The skin of a hand has nearly one colour in a frame. Cells look more like hand the likelier their
// colour is of those that the hand has near its arm, or anywhere when no arm touches it, and less
// the likelier it is of what is neither hand nor arm. What the net takes for fingers on a printed
// box falls so, and fingers that it has missed rise. Arms stay arms.
void weigh_colors(FrameParts& parts);

}  // namespace graspdb
