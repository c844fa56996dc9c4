// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace graspdb {

// Stands where a metric does not apply.
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace graspdb
