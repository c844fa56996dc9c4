// SPDX-License-Identifier: MIT
// From what each cell of a frame looks like to the hand that is meant.
#pragma once

#include <optional>

#include "graspdb/features/hand_finder.h"

namespace graspdb {

constexpr std::uint8_t kLikeAnyOther = 128;  // in PartCells: the part as much as another

// The hand of which most is seen within `roi`. What a held object cuts off belongs to it, and so
// do other pieces nearby, unless both have arms that do not touch. Cells of all parts that are not
// its own are 0 afterwards. None when no hand has so many cells.
std::optional<FrameParts> largest_hand(const FrameParts& parts, int min_cells,
                                       const std::optional<Box>& roi);

// Around all cells that look like hand, in pixels of the frame.
Box hand_box(const FrameParts& parts);

// The pixels of a frame of this size where cells between them are 128 or more.
Mask painted(const PartCells& cells, const FrameParts& parts, int width, int height);

}  // namespace graspdb
