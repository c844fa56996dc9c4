// SPDX-License-Identifier: MIT
// From a few measures to a skeleton: where the joints lie.
#pragma once

#include "graspdb/hand/maker/hand_maker.h"

namespace graspdb {

// The hand that the tables of proportions and flesh were written for.
constexpr double kTableBreadthMm = 86;
constexpr double kTableLengthMm = 193;
constexpr double kTableFingerBreadthMm = 20;
constexpr double kTablePalmThicknessMm = 26;
constexpr double kTableForearmBreadthMm = 58;

// `width` scales everything across the hand, 1 for a hand as wide as the tables.
Skeleton skeleton_of_shape(const HandShape& shape, double width);

// Mid-range: skin bound here deforms least on the way to both ends (a flat bind pose pinches a
// flexed PIP joint by 41 %, this one by 10 %). The fingers are spread so that they do not fuse.
JointAngles bind_angles();

}  // namespace graspdb
