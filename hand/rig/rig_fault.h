// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "graspdb/core/error.h"
#include "rig_file.h"
#include "rig_map.h"

namespace graspdb {

// What a map says and a file has not: the Error names both.
[[noreturn]] inline void fail(const RigMap& map, const RigFile& file, const std::string& key,
                              const std::string& expected, const std::string& found) {
  throw Error({map.file, key, expected, found + " in " + file.path});
}

}  // namespace graspdb
