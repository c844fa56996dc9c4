// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/core/image.h"
#include "graspdb/pictures/estimate_picture.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// The steps from a frame to its answer, on one page: the hand that was found in it, and where its
// arm is; the crop that is described; the rows that were weighed, heaviest first, or the nearest
// one when it was too far away; and the answer, or why there is none. Without `rows` these are
// named only. Throws Error as EstimatePicture does.
ColorImage draw_explanation(const ColorImage& frame, const Estimate& estimate,
                            const Database& database, EstimatePicture* rows);

}  // namespace graspdb
