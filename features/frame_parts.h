// SPDX-License-Identifier: MIT
// From what each cell of a frame looks like to the hand that is meant.
#pragma once

#include <initializer_list>
#include <optional>

#include "graspdb/features/hand_finder.h"
#include "regions.h"

namespace graspdb {

constexpr std::uint8_t kLikeAnyOther = 128;  // in PartCells: the part as much as another

// Cells that look like one of these parts more than like anything else.
Mask cells_of(const FrameParts& parts, std::initializer_list<PartCells FrameParts::*> shown);

// Whether masks of one size share a pixel.
bool touch(const Mask& a, const Mask& b);

// By a cell on all sides: pieces that are two cells apart touch.
Mask grown(Mask cells);

// Of the arms with so many cells those that share one with the piece.
Mask arms_of(const Mask& piece, const Regions& arms, int min_cells = 0);

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
