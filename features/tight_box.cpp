// SPDX-License-Identifier: MIT
#include <algorithm>

#include "graspdb/features/hog.h"

namespace graspdb {

std::optional<Box> tight_box(const Mask& mask) {
  std::vector<std::uint8_t> columns(static_cast<std::size_t>(mask.width()));
  int top = mask.height(), bottom = -1;
  for (int y = 0; y < mask.height(); ++y) {
    const std::uint8_t* row = mask.row(y);
    std::uint8_t any = 0;
    for (std::size_t x = 0; x < columns.size(); ++x) {
      columns[x] |= row[x];
      any |= row[x];
    }
    if (any == 0) continue;
    top = std::min(top, y);
    bottom = y;
  }
  if (bottom < 0) return std::nullopt;
  const auto inside = [](std::uint8_t column) { return column != 0; };
  const auto left = std::find_if(columns.begin(), columns.end(), inside) - columns.begin();
  const auto right = columns.rend() - std::find_if(columns.rbegin(), columns.rend(), inside);
  return Box{static_cast<int>(left), top, static_cast<int>(right - left), bottom - top + 1};
}

}  // namespace graspdb
