// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "embree.h"
#include "graspdb/renderer/renderer.h"
#include "triangle_raster.h"

namespace graspdb {

struct Surface {
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector3f> positions;  // hand frame
  std::vector<ShadingVertex> vertices;
  Facets facets;
  std::vector<std::uint8_t> parts;  // one a vertex, or empty
};

struct Scene::State {
  embree::SceneHandle embree;
  std::array<Surface, 2> surfaces;  // hand, object: Embree's geometry numbers
};

}  // namespace graspdb
