// SPDX-License-Identifier: MIT
// Labelled views for people to look at.
#pragma once

#include <string>

#include "graspdb/core/image.h"
#include "graspdb/pictures/labelled_view.h"

namespace graspdb {

// All layers of one view beside each other, the keypoints drawn over the first. The view has all
// layers.
ColorImage draw_view_sheet(const LabelledView& view, const std::string& title);

}  // namespace graspdb
