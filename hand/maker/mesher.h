// SPDX-License-Identifier: MIT
// Triangles on the zero set of a hand's surface.
#pragma once

#include <vector>

#include "graspdb/core/mesh.h"
#include "surface.h"

namespace graspdb {

struct RawMesh {  // millimetres
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

// Closed, 2-manifold, of one piece without handles, counter-clockwise from outside. `cell` is the
// size of the sampling grid in millimetres. Throws Error when no grid gives such a mesh, as for
// fingers that touch.
RawMesh mesh_surface(const HandSurface& surface, double cell);

// Evens out the triangles along the surface and moves every vertex onto it.
void relax(const HandSurface& surface, int passes, RawMesh& mesh);

}  // namespace graspdb
