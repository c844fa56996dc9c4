// SPDX-License-Identifier: MIT
// Runs the scripts of scripts/blender. Blender is no part of graspdb's packages: where it is absent
// these tests are skipped, and say so.
#pragma once

#include <string>

namespace graspdb::testing {

bool has_blender();
constexpr const char* kNoBlender = "no blender on the path (Debian: blender, python3-numpy)";

struct BlenderOutcome {
  int code = 0;        // of the exit
  std::string output;  // all that it printed
};

// `scene` is a .blend, or empty; `script` lies under the project's root; `arguments` goes to a
// shell.
BlenderOutcome run_blender(const std::string& scene, const std::string& script,
                           const std::string& arguments);

}  // namespace graspdb::testing
