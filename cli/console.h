// SPDX-License-Identifier: MIT
// What verbs share on the console.
#pragma once

#include <string>

#include "graspdb/core/progress.h"

namespace graspdb::cli {

// On a terminal a bar with rate and time left; elsewhere a line every few seconds. A total of 0 is
// unknown. The bar ends when done and total are equal.
Progress console_progress(const std::string& what, const std::string& unit);

// A check of CLI11, whose ranges let NaN pass: an empty answer says that all is well.
std::string check_not_nan(const std::string& number);

}  // namespace graspdb::cli
