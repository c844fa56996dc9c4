// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace graspdb {

// Told how much of a long work is done. Libraries call it from any thread, one call at a time;
// the command line draws it. An empty function is allowed: nobody listens.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace graspdb
