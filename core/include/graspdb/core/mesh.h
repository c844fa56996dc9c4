// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace graspdb {

using Triangle = std::array<std::uint32_t, 3>;

// A triangle mesh in metres; triangles run counter-clockwise seen from outside. `normals` holds one
// unit normal a vertex. `albedo` is either empty (all 1) or one grey factor 0..1 a vertex.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Triangle> triangles;
  std::vector<float> albedo;
};

}  // namespace graspdb
