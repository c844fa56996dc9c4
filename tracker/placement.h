// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/database/database.h"

namespace graspdb {

// Where a row's hand must be so that it fills the observed box as it filled its own picture.
struct Placement {
  // Turns the ray through the middle of the row's box to that through the observed one's: the two
  // hands look alike in their boxes, however far away they are.
  Eigen::Matrix3d camera_from_row_camera;
  Eigen::Vector3d palm_center;  // camera frame, metres
};

// `row_box` is the row's own box, seen from `row_distance` metres.
Placement place(const Box& observed, const Intrinsics& camera, const BoxTangents& row_box,
                double row_distance);

// How much wider for its height the observed box is than the row's, as a logarithm. The descriptor
// does not know: it is stretched with its box.
double log_stretch(const Box& observed, const Intrinsics& camera, const BoxTangents& row_box);

}  // namespace graspdb
