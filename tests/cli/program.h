// SPDX-License-Identifier: MIT
// Runs the built program as a user does.
#pragma once

#include <filesystem>
#include <string>

namespace graspdb::testing {

struct Outcome {
  int code = 0;  // of the exit; -1 when a signal ended it
  std::string out, err;
};

// `arguments` goes to a shell.
Outcome run_program(const std::string& arguments);

// A database of one grasp, closed, in 24 small views. Returns the outcome of `build --json`.
Outcome build_tiny(const std::filesystem::path& file);

// How many line ends a text has.
int lines_of(const std::string& text);

}  // namespace graspdb::testing
