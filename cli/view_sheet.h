// SPDX-License-Identifier: MIT
// Labelled views for people to look at.
#pragma once

#include <string>

#include "graspdb/image.h"
#include "graspdb/labelled_view.h"

namespace graspdb::cli {

// All layers of one view beside each other, the keypoints drawn over the first. The view has all
// layers.
ColorImage draw_view_sheet(const LabelledView& view, const std::string& title);

}  // namespace graspdb::cli
