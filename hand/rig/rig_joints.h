// SPDX-License-Identifier: MIT
#pragma once

#include "rest_frames.h"
#include "rig_file.h"
#include "rig_map.h"

namespace graspdb {

// Metres from the file's coordinates; the mirror makes a left hand a right one.
Eigen::DiagonalMatrix<double, 3> meters_from_file(const RigMap& map);

// Where a hand's joints lie at rest: those of the file, corrected as the map says, and those that
// it lacks by rule. Throws Error, naming map, file and bone, for a joint that is not there and for
// joints that no hand has.
RestJoints rest_joints(const RigMap& map, const RigFile& file);

}  // namespace graspdb
