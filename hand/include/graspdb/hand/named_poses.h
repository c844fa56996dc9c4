// SPDX-License-Identifier: MIT
// Poses that hands are looked at and measured in; all within the angles' ranges, the wrist
// straight.
//   flat    all angles zero
//   fist    fully closed, the thumb across the index's and middle finger's middle phalanges
//   wrap    round a cylinder of 60 mm: as an adult hand closes on it
//   pinch   the pulps of thumb and index together, the other fingers relaxed
//   hook    as on a handle: knuckles nearly straight, the other finger joints strongly bent
#pragma once

#include <array>
#include <string_view>

#include "graspdb/hand/angles.h"

namespace graspdb {

constexpr std::array<std::string_view, 5> kNamedPoses = {"flat", "fist", "wrap", "pinch", "hook"};

// Throws Error for a name that is not in kNamedPoses. Thread-safe.
const JointAngles& named_pose(std::string_view name);

}  // namespace graspdb
