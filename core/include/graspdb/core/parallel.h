// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace graspdb {

// The one parallel loop: calls body(i) once for every i in [0, count), on `threads` threads
// (0 = all processors). Calls come in no fixed order. The first exception thrown by a body stops
// the loop and is thrown here.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace graspdb
