// SPDX-License-Identifier: MIT
#include "graspdb/hand/label.h"

#include <algorithm>
#include <cmath>

#include "graspdb/core/transform.h"

namespace graspdb {

Label pack_label(const LabelPose& pose) {
  Label label;
  Eigen::Map<Eigen::Vector3f>(label.data()) = vector_from_rotation(pose.rotation).cast<float>();
  Eigen::Map<Eigen::Matrix<float, kAngleCount, 1>>(label.data() + 3) = pose.angles.cast<float>();
  return label;
}

LabelPose unpack_label(LabelView label) {
  return {rotation_from_vector({label[0], label[1], label[2]}),
          Eigen::Map<const Eigen::Matrix<float, kAngleCount, 1>>(label.data() + 3).cast<double>()};
}

bool is_finite(LabelView label) {
  return std::all_of(label.begin(), label.end(), [](float value) { return std::isfinite(value); });
}

}  // namespace graspdb
