// SPDX-License-Identifier: MIT
// The flat hand that all angles are measured from: forearm, palm and fingers in one line, fingers
// parallel to the middle metacarpal in the palm's plane, the thumb straight beside them.
#pragma once

#include <Eigen/Core>
#include <array>

#include "graspdb/hand/skeleton.h"

namespace graspdb {

// The frame with its y along `y` and its z as near to `z` as that allows.
Eigen::Matrix3d frame_along(const Eigen::Vector3d& y, const Eigen::Vector3d& z);

// How a finger's bones are turned at zero: rolled a few degrees about y with the palm's arch.
Eigen::Matrix3d finger_zero_rotation(int finger);

// Thumb at zero: 38 degrees radial, slightly palmar, the nail 85 degrees from dorsal to radial. So
// flexion sweeps across the palm and abduction is palmar. (With the nail at 50 degrees the thumb's
// pulp meets the little finger's in a tenth as many poses.)
Eigen::Matrix3d thumb_zero_rotation();

// What the joints' places say of a hand, in the hand frame, metres; digits from thumb to little.
struct HandMeasures {
  std::array<Eigen::Vector3d, 5> cmc;
  std::array<Eigen::Vector3d, kFingerCount> mcp;  // of the four fingers
  // The three bones that reach the tip: of the thumb from its metacarpal on, of a finger its
  // phalanges.
  std::array<std::array<double, 3>, 5> lengths;
};
Skeleton skeleton_from_measures(const HandMeasures& measures);

}  // namespace graspdb
