// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "graspdb/core/image.h"

namespace graspdb {

// The paper's segmentation noise: every hand pixel is dropped with probability alpha_percent / 100,
// then 3 erosions and 3 dilations, 3x3. At 0 the mask stays as it is. A pure function of its
// arguments.
Mask add_segmentation_noise(const Mask& hand, double alpha_percent, std::uint64_t seed,
                            std::uint64_t frame);

}  // namespace graspdb
