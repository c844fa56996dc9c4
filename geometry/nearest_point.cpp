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
  for (const Eigen::Vector3f& point : points_) box_.extend(point);
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
  search(points_, 0, box_, to.cast<float>(), nearest2);
  return std::sqrt(static_cast<double>(nearest2));
}

// All of `part` lies in `box`: summed up like its points, the box is never the further one.
void NearestPoint::search(Part part, int axis, const Eigen::AlignedBox3f& box,
                          const Eigen::Vector3f& to, float& nearest2) {
  if (part.empty()) return;
  const Eigen::Vector3f away = (box.min() - to).cwiseMax(to - box.max()).cwiseMax(0);
  if (away.squaredNorm() >= nearest2) return;
  const std::size_t middle = part.size() / 2;
  nearest2 = std::min(nearest2, (part[middle] - to).squaredNorm());
  const float border = part[middle][axis];
  Eigen::AlignedBox3f low = box, high = box;
  low.max()[axis] = high.min()[axis] = border;
  const auto search_low = [&] { search(part.first(middle), (axis + 1) % 3, low, to, nearest2); };
  const auto search_high = [&] {
    search(part.subspan(middle + 1), (axis + 1) % 3, high, to, nearest2);
  };
  if (to[axis] < border) {
    search_low();
    search_high();
  } else {
    search_high();
    search_low();
  }
}

}  // namespace graspdb
