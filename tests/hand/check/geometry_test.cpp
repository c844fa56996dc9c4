// SPDX-License-Identifier: MIT
#include "geometry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

Vector3d drawn(RandomStream& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(HandCheckGeometry, VolumeOfATetrahedronIsASixthOfItsBox) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_NEAR(volume_of(mesh), 1, 1e-6);
}

TEST(HandCheckGeometry, ARayMeetsTheNearestTriangleBeforeIt) {
  const Corners near{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}}, far{{-1, -1, 5}, {0, 1, 5}, {1, -1, 5}};
  const Corners behind{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
  const std::array<Corners, 3> all = {far, behind, near};
  EXPECT_EQ(distance_along(Vector3d::Zero(), Vector3d::UnitZ(), all), 2);
  EXPECT_EQ(distance_along(Vector3d::Zero(), -Vector3d::UnitZ(), all), 1);
  EXPECT_EQ(distance_along({3, 0, 0}, Vector3d::UnitZ(), all), std::nullopt);
  EXPECT_EQ(distance_along(Vector3d::Zero(), Vector3d::UnitX(), all), std::nullopt);
}

TEST(HandCheckGeometry, DistanceToATriangleIsTheLeastToItsPoints) {
  RandomStream random(1);
  for (int i = 0; i < 50; ++i) {
    const Corners t{drawn(random), drawn(random), drawn(random)};
    const Vector3d point = 2 * drawn(random);
    double least = 100;
    constexpr int kFine = 200;
    for (int u = 0; u <= kFine; ++u) {
      for (int v = 0; u + v <= kFine; ++v) {
        const Vector3d on = t.a + (t.b - t.a) * u / kFine + (t.c - t.a) * v / kFine;
        least = std::min(least, (on - point).norm());
      }
    }
    EXPECT_NEAR(distance_to_triangle(point, t), least, .02);
    EXPECT_LE(distance_to_triangle(point, t), least + 1e-12);
  }
}

TEST(HandCheckGeometry, DistanceToASegmentEndsAtItsEnds) {
  const Vector3d a(0, 0, 0), b(2, 0, 0);
  EXPECT_EQ(distance_to_segment({1, 3, 0}, a, b), 3);
  EXPECT_EQ(distance_to_segment({-4, 3, 0}, a, b), 5);
  EXPECT_EQ(distance_to_segment({5, 0, 4}, a, b), 5);
  EXPECT_EQ(distance_to_segment({0, 3, 4}, a, a), 5);
}

}  // namespace
}  // namespace graspdb
