// SPDX-License-Identifier: MIT
#include "nearest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"

namespace graspdb {

NearestPoint::NearestPoint(std::vector<Eigen::Vector3f> points) : points_(std::move(points)) {
  GRASPDB_CHECK(!points_.empty());
  sort(points_, 0);
}

// The middle one parts the others along the axis.
void NearestPoint::sort(std::span<Eigen::Vector3f> part, int axis) {
  if (part.size() < 2) return;
  const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
  std::nth_element(part.begin(), middle, part.end(),
                   [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  sort(part.first(part.size() / 2), (axis + 1) % 3);
  sort(part.subspan(part.size() / 2 + 1), (axis + 1) % 3);
}

double NearestPoint::distance(const Eigen::Vector3d& to) const {
  float nearest2 = std::numeric_limits<float>::infinity();
  search(points_, 0, to.cast<float>(), nearest2);
  return std::sqrt(static_cast<double>(nearest2));
}

void NearestPoint::search(Part part, int axis, const Eigen::Vector3f& to, float& nearest2) {
  if (part.empty()) return;
  const std::size_t middle = part.size() / 2;
  nearest2 = std::min(nearest2, (part[middle] - to).squaredNorm());
  const float beyond = to[axis] - part[middle][axis];
  const Part low = part.first(middle), high = part.subspan(middle + 1);
  search(beyond < 0 ? low : high, (axis + 1) % 3, to, nearest2);
  if (beyond * beyond < nearest2) search(beyond < 0 ? high : low, (axis + 1) % 3, to, nearest2);
}

}  // namespace graspdb
