// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace graspdb::testing {

// The project's own folder, with its assets, grasps and sequences.
inline const std::filesystem::path kSource = GRASPDB_SOURCE_DIR;
inline const std::filesystem::path kGrasps = kSource / "grasps";

}  // namespace graspdb::testing
