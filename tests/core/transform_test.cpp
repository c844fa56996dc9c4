// SPDX-License-Identifier: MIT
#include "graspdb/core/transform.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

Eigen::Vector3d random_vector(RandomStream& random, double length) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized() * length;
}

TEST(Transform, RotationVectorComesBackForEveryAngleUpToPi) {
  RandomStream random(1);
  for (double angle : {0.0, 1e-14, 1e-9, 1e-4, 0.5, 1.5, 3.0, 3.1415, 3.14159265}) {
    const Eigen::Vector3d v = random_vector(random, angle);
    EXPECT_LT((vector_from_rotation(rotation_from_vector(v)) - v).norm(), 1e-9) << angle;
  }
}

TEST(Transform, InverseUndoesAndCompositionChains) {
  RandomStream random(2);
  const RigidTransform b_from_a{rotation_from_vector(random_vector(random, 1)), {1, 2, 3}};
  const RigidTransform c_from_b{rotation_from_vector(random_vector(random, 2)), {-1, 0, 5}};
  const Eigen::Vector3d p(0.3, -0.2, 0.9);
  EXPECT_LT((b_from_a.inverse() * (b_from_a * p) - p).norm(), 1e-12);
  EXPECT_LT(((c_from_b * b_from_a) * p - c_from_b * (b_from_a * p)).norm(), 1e-12);
}

TEST(Transform, AngleBetweenIsTheGeodesicAngle) {
  RandomStream random(3);
  for (double angle : {0.0, 1e-6, 0.1, 1.0, 2.0, 3.14}) {
    const Eigen::Matrix3d a = rotation_from_vector(random_vector(random, 1.3));
    const Eigen::Matrix3d b = a * rotation_from_vector(random_vector(random, angle));
    EXPECT_NEAR(angle_between(a, b), angle, 1e-9);
  }
}

TEST(Transform, AxisRotationIsRightHanded) {
  EXPECT_LT(
      (axis_rotation(2, kPi / 2) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
      1e-15);
}

TEST(Transform, RotationFromAxesKeepsTheFirstAndComesNearTheSecond) {
  RandomStream random(4);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d first = random_vector(random, 2), second = random_vector(random, .1);
    const Eigen::Matrix3d rotation = rotation_from_axes(axis, first, second);
    EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(rotation.determinant(), 1, 1e-12);
    EXPECT_LT((rotation.col(axis) - first.normalized()).norm(), 1e-15);
    // Nearest among all directions that are square to the first one.
    const Eigen::Vector3d square = second - first * first.dot(second) / first.squaredNorm();
    EXPECT_LT((rotation.col((axis + 1) % 3) - square.normalized()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace graspdb
