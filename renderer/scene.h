// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "embree.h"
#include "graspdb/renderer.h"

namespace graspdb {

// What a hit needs of a vertex, side by side in memory.
struct ShadingVertex {
  Eigen::Vector3f normal;
  float albedo;
  float openness;
};

struct Surface {
  std::vector<Triangle> triangles;
  std::vector<ShadingVertex> vertices;
  std::vector<std::uint8_t> parts;  // one a vertex, or empty
};

struct Scene::State {
  embree::SceneHandle embree;
  std::array<Surface, 2> surfaces;  // hand, object: Embree's geometry numbers
};

}  // namespace graspdb
