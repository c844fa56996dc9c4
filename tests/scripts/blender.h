// SPDX-License-Identifier: MIT
// Runs the scripts of scripts/blender. Blender is no part of graspdb's packages: where it is absent
// these tests are skipped, and say so.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace graspdb::testing {

bool has_blender();
constexpr const char* kNoBlender = "no blender on the path (Debian: blender, python3-numpy)";

struct BlenderOutcome {
  int code = 0;        // of the exit
  std::string output;  // all that it printed
};

// `scene` is a .blend, a script that makes a scene, or empty; `script` is seen from the project's
// root.
BlenderOutcome run_blender(const std::filesystem::path& scene, const std::filesystem::path& script,
                           const std::vector<std::string>& arguments);

}  // namespace graspdb::testing
