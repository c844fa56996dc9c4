// SPDX-License-Identifier: MIT
// What assimp is given instead of the bytes of a file: the parts that make a shape and its skin,
// checked and written again. Both throw Error, with `file` for the file's name.
#pragma once

#include <string>
#include <string_view>

namespace graspdb {

constexpr double kLargestCoordinate = 1e7;
constexpr std::size_t kDeepestNode = 512;

// Vertices, normals, faces, and the names of objects, groups and materials.
std::string reduced_obj(std::string_view text, const std::string& file);

// The default scene's nodes, meshes of triangles, skins and what these use of the binary chunk.
std::string reduced_glb(std::string_view bytes, const std::string& file);

}  // namespace graspdb
