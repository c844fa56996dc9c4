// SPDX-License-Identifier: MIT
// Rigid transforms. A transform is named target_from_source: it takes the coordinates of a point
// in the source frame to those in the target frame, and c_from_a = c_from_b * b_from_a.
#pragma once

#include <Eigen/Geometry>

namespace graspdb {

struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  // metres

  RigidTransform inverse() const;
};

RigidTransform operator*(const RigidTransform& c_from_b, const RigidTransform& b_from_a);
Eigen::Vector3d operator*(const RigidTransform& b_from_a, const Eigen::Vector3d& point_in_a);

// The rotation by |v| radians about v, and its inverse. The vector's length is at most pi.
Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& v);
Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation);

// Rotation by `angle` radians about a coordinate axis (0 = x, 1 = y, 2 = z), right-handed.
Eigen::Matrix3d axis_rotation(int axis, double angle);

// The smallest rotation that takes the direction of `from` to that of `to`; neither is zero.
Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// The rotation whose axis `axis` (as above) lies along `first`, and whose next one (after z comes
// x) lies as near to `second` as that allows. Neither is 0, nor are they parallel.
Eigen::Matrix3d rotation_from_axes(int axis, const Eigen::Vector3d& first,
                                   const Eigen::Vector3d& second);

// The angle in radians, 0..pi, of the rotation that takes one to the other.
double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

constexpr double kMillimetersPerMeter = 1000;
constexpr double kPi = 3.14159265358979323846;
constexpr double radians(double degrees) {
  return degrees * kPi / 180.0;
}
constexpr double degrees(double radians) {
  return radians * 180.0 / kPi;
}

}  // namespace graspdb
