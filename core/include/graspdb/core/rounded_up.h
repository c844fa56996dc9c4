// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace graspdb {

// The smallest multiple of `step`, which is not 0, that holds `count`.
constexpr std::size_t rounded_up(std::size_t count, std::size_t step) {
  return (count + step - 1) / step * step;
}

}  // namespace graspdb
