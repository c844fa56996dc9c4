// SPDX-License-Identifier: MIT
#include "graspdb/core/transform.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace graspdb {

RigidTransform RigidTransform::inverse() const {
  return {rotation.transpose(), -(rotation.transpose() * translation)};
}

RigidTransform operator*(const RigidTransform& c_from_b, const RigidTransform& b_from_a) {
  return {c_from_b.rotation * b_from_a.rotation,
          c_from_b.rotation * b_from_a.translation + c_from_b.translation};
}

Eigen::Vector3d operator*(const RigidTransform& b_from_a, const Eigen::Vector3d& point_in_a) {
  return b_from_a.rotation * point_in_a + b_from_a.translation;
}

Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& v) {
  const double angle = v.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
}

Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation) {
  // Through the quaternion, which stays accurate near both 0 and pi.
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2 * q.vec();
  return q.vec() * (2 * std::atan2(sine, q.w()) / sine);
}

Eigen::Matrix3d axis_rotation(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
}

Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

Eigen::Matrix3d rotation_from_axes(int axis, const Eigen::Vector3d& first,
                                   const Eigen::Vector3d& second) {
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  Eigen::Matrix3d rotation;
  rotation.col(axis) = first.normalized();
  rotation.col(last) = rotation.col(axis).cross(second).normalized();
  rotation.col(next) = rotation.col(last).cross(rotation.col(axis));
  return rotation;
}

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  // ||a - b||_F = 2 sqrt(2) sin(angle / 2); unlike the trace it keeps small angles exact.
  return 2 * std::asin(std::min(1.0, (a - b).norm() / (2 * std::sqrt(2.0))));
}

}  // namespace graspdb
