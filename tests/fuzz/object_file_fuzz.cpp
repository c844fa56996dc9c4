// SPDX-License-Identifier: MIT
// Whatever an object's .glb, .gltf or .obj holds: it gives a solid whose mesh is sound, or an Error
// refuses it.
#include <algorithm>
#include <cstdlib>

#include "glb_mutator.h"
#include "graspdb/core/error.h"
#include "graspdb/geometry/mesh_solid.h"
#include "named_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = graspdb::testing::text_of(data, size);
  const char* name = bytes.starts_with("glTF") ? "object.glb"
                     : bytes.starts_with("{")  ? "object.gltf"
                                               : "object.obj";
  try {
    const auto solid = graspdb::load_mesh_solid(graspdb::testing::named_file(name, bytes), 1e-3);
    const graspdb::Mesh& mesh = solid->mesh();
    const auto is_inside = [&](std::uint32_t vertex) { return vertex < mesh.vertices.size(); };
    for (const graspdb::Triangle& triangle : mesh.triangles) {
      if (!std::ranges::all_of(triangle, is_inside)) std::abort();
    }
    if (!solid->half_extents().allFinite()) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
