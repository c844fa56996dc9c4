// SPDX-License-Identifier: MIT
// What verbs share on the console.
#pragma once

#include <string>

#include "graspdb/core/progress.h"

namespace graspdb::cli {

// On a terminal a bar with rate and time left; elsewhere a line every few seconds. A total of 0 is
// unknown. The bar ends when done and total are equal.
Progress console_progress(const std::string& what, const std::string& unit);

// From now on the first Ctrl-C (or SIGTERM) only sets interrupted(), so that what was done is kept;
// a second one ends the program.
void stop_on_interrupt();
bool interrupted();

}  // namespace graspdb::cli
