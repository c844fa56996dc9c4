// SPDX-License-Identifier: MIT
// Many vertices through one camera. The same bytes with every instruction set.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "graspdb/core/camera.h"

namespace graspdb {

// Where a camera sees a vertex, in pixels, and the inverse of its depth in 1/m.
struct ProjectedVertex {
  float x, y, inverse_z;
};

// Where `vertices` lie before a camera: the bounds of x / z and y / z, and the least z.
struct TangentBounds {
  Eigen::Array2f low, high;
  float nearest;
};
TangentBounds tangent_bounds(std::span<const Eigen::Vector3f> vertices,
                             const RigidTransform& camera_from_hand);

// Sets one ProjectedVertex for each of `vertices`; returns the least z.
float project_vertices(std::span<const Eigen::Vector3f> vertices, const Camera& camera,
                       std::span<ProjectedVertex> projected);

}  // namespace graspdb
