// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "graspdb/core/error.h"

namespace graspdb {

// Throws the Error of a file whose content is wrong.
[[noreturn]] inline void refuse(const std::string& file, const std::string& key,
                                const std::string& expected, const std::string& found) {
  throw Error({.file = file, .key = key, .expected = expected, .found = found});
}

}  // namespace graspdb
