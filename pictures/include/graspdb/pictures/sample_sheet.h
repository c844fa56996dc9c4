// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "graspdb/core/image.h"
#include "graspdb/samples/samples.h"

namespace graspdb {

// The first hundred samples or so, each as what the descriptor reads (masked grey, mask, scene) and
// its label: the joints in the crop's frame, 25 cm a side.
ColorImage draw_sample_sheet(std::span<const Sample> samples);

}  // namespace graspdb
