// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "graspdb/core/transform.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

// What two pulps that meet may miss: the distance between them, and the angle between the ways they
// look, turned about.
constexpr double kGapGate = .002;  // metres
constexpr double kFacingGate = radians(60);

struct Meeting {
  double gap, facing;

  double badness() const;  // the larger of both, in parts of its gate
};

// A digit, from the thumb (0) to the little finger (4), and its pulp in the frame of its distal
// bone; the pulp looks palmar.
struct DigitPulp {
  int digit;
  Eigen::Vector3d in_distal;
};

// Where thumb and finger meet best within the angles' ranges, the other angles at zero. The two
// chains are sampled apart and paired, because a descent from one start is caught by the facing;
// from the best pairs damped least squares goes on. Deterministic, some ten milliseconds.
Meeting best_meeting(const Skeleton& skeleton, const DigitPulp& thumb, const DigitPulp& finger);

}  // namespace graspdb
