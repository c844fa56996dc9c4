// SPDX-License-Identifier: MIT
#include "placement.h"

#include <cmath>

#include "graspdb/core/transform.h"

namespace graspdb {

Placement place(const Box& observed, const Intrinsics& camera, const BoxTangents& row_box,
                double row_distance) {
  const double width = observed.width / camera.fx;
  const double height = observed.height / camera.fy;
  const double scale = std::sqrt(width * height / (row_box.width * row_box.height));
  // The palm centre lies as far from the box's centre as in the row, scaled.
  const Eigen::Vector3d box_center =
      camera.ray(observed.x - 0.5 + 0.5 * observed.width, observed.y - 0.5 + 0.5 * observed.height);
  const Eigen::Vector3d offset(row_box.x + 0.5 * row_box.width, row_box.y + 0.5 * row_box.height,
                               0);
  const Eigen::Vector3d ray = (box_center - scale * offset).normalized();
  // A flat picture enlarges what is off its axis: lengths by 1 / cos along and 1 / cos^2 away from
  // it.
  const double enlarged = std::pow(ray.z(), -1.5);
  const Eigen::Vector3d palm_center = ray * (row_distance * enlarged / scale);
  // By way of the optical axis, as a camera that looks at the box would be turned.
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond turn =
      rotation_between(axis, box_center) * rotation_between(offset + axis, axis);
  return {turn.toRotationMatrix(), palm_center};
}

double log_stretch(const Box& observed, const Intrinsics& camera, const BoxTangents& row_box) {
  return std::log((observed.width / camera.fx) / (observed.height / camera.fy) /
                  (static_cast<double>(row_box.width) / row_box.height));
}

}  // namespace graspdb
