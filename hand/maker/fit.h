// SPDX-License-Identifier: MIT
// The flesh that measures what was asked.
#pragma once

#include "surface.h"

namespace graspdb {

// Bone frames in the bind pose, and the skin on them.
BoneFramesMm bind_frames_mm(const Skeleton& skeleton);
HandSurface surface_of_shape(const HandShape& shape, const FleshScales& scales);

// The scales at which the skin has the breadths and the thickness of `shape`.
FleshScales fitting_scales(const HandShape& shape);

}  // namespace graspdb
