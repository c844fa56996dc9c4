// SPDX-License-Identifier: MIT
#pragma once

#include "mesher.h"

namespace graspdb {

// Which bones move each vertex, from where it lies among the bones (`frames` in the pose of the
// mesh). `width` as in skeleton_of_shape.
std::vector<SkinWeights> skin_weights(const HandSurface& surface, const RawMesh& mesh,
                                      const BoneFramesMm& frames, double width);

}  // namespace graspdb
