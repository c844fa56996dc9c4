// SPDX-License-Identifier: MIT
// Solids that are meshes.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "graspdb/geometry/solid.h"

namespace graspdb {

// Reads any file that assimp reads, moves the middle of its box to the origin and requires a
// surface that is closed, faces outwards and does not cut itself. Throws Error, which says by how
// much it is not.
//
// A COLLADA or FBX file that states its unit is read in that one, and any glTF file without
// `meters_per_unit` in metres. Throws Error when `meters_per_unit` is another unit than the stated
// one, or is missing for a file that states none. Axes are those of the file.
std::shared_ptr<const Solid> load_mesh_solid(const std::filesystem::path& file,
                                             std::optional<double> meters_per_unit);

// Whether files of that name can say what unit they are in.
bool can_state_unit(const std::filesystem::path& file);

// `mesh` is what is drawn, as Solid::mesh() says; `file` stands for it in messages.
std::shared_ptr<const Solid> make_mesh_solid(Mesh mesh, const std::filesystem::path& file);

}  // namespace graspdb
