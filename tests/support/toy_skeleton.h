// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/hand/skeleton.h"

namespace graspdb::testing {

// A hand of round numbers: fingers 20 mm apart, metacarpals to 90 mm, phalanges 40, 25 and 20 mm.
inline Skeleton toy_skeleton() {
  Skeleton skeleton;
  auto& zero = skeleton.hand_from_bone_at_zero;
  for (int f = 0; f < kFingerCount; ++f) {
    const double x = -0.03 + 0.02 * f;
    const double starts[] = {0.025, 0.090, 0.130, 0.155};
    for (int b = 0; b < 4; ++b) {
      zero[static_cast<std::size_t>(kFirstFingerBone + 4 * f + b)].translation = {x, starts[b], 0};
    }
    skeleton.tip_in_distal[static_cast<std::size_t>(f + 1)] = {0, 0.02, 0};
  }
  // The thumb: 40 degrees radial, nail turned 85 degrees from dorsal towards radial.
  const Eigen::Matrix3d thumb = axis_rotation(2, radians(40)) * axis_rotation(1, radians(-85));
  const double lengths[] = {0, 0.045, 0.080};
  for (std::size_t b = 0; b < 3; ++b) {
    zero[kThumbMetacarpal + b] = {thumb,
                                  Eigen::Vector3d(-0.02, 0.02, 0) + thumb.col(1) * lengths[b]};
  }
  skeleton.tip_in_distal[0] = {0, 0.03, 0};
  return skeleton;
}

}  // namespace graspdb::testing
