// SPDX-License-Identifier: MIT
#pragma once

#include "graspdb/features/hog.h"

namespace graspdb::testing {

// A bin of the cell in this row and column.
inline int bin_at(const Descriptor& descriptor, int row, int column, int bin) {
  return descriptor[static_cast<std::size_t>((row * 8 + column) * 8 + bin)];
}

}  // namespace graspdb::testing
