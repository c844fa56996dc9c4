// SPDX-License-Identifier: MIT
// Draws triangles by testing each of them against the rays of the few pixels around it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/mesh.h"
#include "graspdb/renderer/renderer.h"
#include "projection.h"
#include "shading.h"

namespace graspdb {

// What shading needs of a vertex, side by side in memory.
struct ShadingVertex {
  Eigen::Vector3f normal;
  float albedo;
  float openness;
};

// Triangles with the planes that they lie in, by which those that face an eye are found quickly.
struct Facets {
  std::vector<Triangle> triangles;
  // One number a triangle: `eye` is on its outer side when normal . eye > offset. Filled up to a
  // multiple of 16 with planes that face nobody.
  std::array<std::vector<float>, 3> normal;
  std::vector<float> offset;
};

// The facets of a closed mesh. Skinning turns a few triangles of a deep crease over, so that their
// backs are seen: those come twice, once for each side.
Facets make_facets(const Mesh& mesh);

struct RasterSurface {
  const Facets& facets;
  std::span<const ShadingVertex> shading;  // one a vertex
  std::span<const ProjectedVertex> seen;   // one a vertex, all of them in front of the camera
  SurfaceLabel label;
};

// The nearest surface of each pixel, drawn one over the other: view.shading and view.label, which
// have their size already, and where nothing is drawn stay as they are. A pixel is covered when its
// centre lies inside a triangle or on its border, as computed from corner and pixel alone:
// triangles that share an edge leave no crack. The same bytes with every instruction set.
void draw_surfaces(std::span<const RasterSurface> surfaces, const Eigen::Vector3f& eye_in_hand,
                   const HandLight& light, View& view);

}  // namespace graspdb
