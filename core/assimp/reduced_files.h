// SPDX-License-Identifier: MIT
// What assimp is given instead of the bytes of a file: the parts that make a shape and its skin,
// checked and written again. All throw Error that names `file`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace graspdb {

constexpr double kLargestCoordinate = 1e7;
constexpr std::size_t kDeepestNode = 512;

// The bytes of a file of at most 256 MiB.
std::string read_limited(const std::filesystem::path& file);

// Vertices, normals, faces, and the names of objects, groups and materials.
std::string reduced_obj(std::string_view text, const std::string& file);

// A .glb: the default scene's nodes, meshes of triangles, skins and their numbers as plain floats
// and whole numbers. Buffers may lie in files beside `file`.
std::string reduced_glb(std::string_view bytes, const std::filesystem::path& file);
std::string reduced_gltf(std::string_view text, const std::filesystem::path& file);  // also a .glb

}  // namespace graspdb
