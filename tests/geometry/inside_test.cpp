// SPDX-License-Identifier: MIT
#include "graspdb/geometry/inside.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graspdb/core/random.h"
#include "graspdb/core/transform.h"
#include "graspdb/geometry/solid.h"

namespace graspdb {
namespace {

Eigen::Vector3d point_within(RandomStream& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

TEST(Inside, InsideTestAgreesWithTheSolid) {
  for (const auto& solid :
       {make_sphere(0.06), make_cylinder(0.05, 0.06), make_box({0.05, 0.04, 0.03})}) {
    const InsideTest inside(solid->mesh());
    RandomStream random(1);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p = point_within(random, 0.035);
      if (std::abs(solid->distance(p)) < 1e-4) continue;  // within the facets' depth
      EXPECT_EQ(inside.depth_along_z(p) > 0, solid->distance(p) < 0);
      EXPECT_GE(inside.depth_along_z(p), -solid->distance(p) - 1e-4);
    }
  }
}

TEST(Inside, InsideOfTwoOverlappingBallsIsInside) {
  Mesh two = make_sphere(0.06)->mesh();
  const Mesh ball = two;
  const auto count = static_cast<std::uint32_t>(ball.vertices.size());
  for (const Eigen::Vector3f& v : ball.vertices) {
    two.vertices.push_back(v + Eigen::Vector3f(0, 0, 0.02F));
  }
  for (const Triangle& t : ball.triangles) {
    two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  const InsideTest inside(two);
  EXPECT_GT(inside.depth_along_z({0, 0, 0.01}), 0);
  EXPECT_GT(inside.depth_along_z({0, 0, -0.02}), 0);
  EXPECT_GT(inside.depth_along_z({0, 0, 0.045}), 0);
  EXPECT_EQ(inside.depth_along_z({0, 0, 0.055}), 0);
}

TEST(Inside, WindingNumberIsOneInsideAndHalfAtACutPlane) {
  const Mesh mesh = make_sphere(0.06)->mesh();
  EXPECT_NEAR(winding_number(mesh, mesh.triangles, {0.01, 0.005, -0.01}), 1, 1e-9);
  EXPECT_NEAR(winding_number(mesh, mesh.triangles, {0.04, 0, 0}), 0, 1e-9);
  std::vector<Triangle> lower;
  for (const Triangle& t : mesh.triangles) {
    const bool below = std::all_of(t.begin(), t.end(),
                                   [&](std::uint32_t v) { return mesh.vertices[v].z() < 1e-6F; });
    if (below) lower.push_back(t);
  }
  EXPECT_NEAR(winding_number(mesh, lower, {0, 0, 0}), 0.5, 1e-3);
}

TEST(Inside, DistanceToTrianglesAgreesWithTheSolid) {
  const auto box = make_box({0.05, 0.04, 0.03});
  RandomStream random(2);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p = point_within(random, 0.05);
    EXPECT_NEAR(distance_to_triangles(box->mesh(), box->mesh().triangles, p, 1),
                std::abs(box->distance(p)), 1e-8);
  }
}

TEST(Inside, DistanceToTrianglesMayStopEarly) {
  const auto ball = make_sphere(0.06);
  const auto& triangles = ball->mesh().triangles;
  EXPECT_LE(distance_to_triangles(ball->mesh(), triangles, {0, 0, 0.028}, 1, 0.04), 0.04);
  EXPECT_EQ(distance_to_triangles(ball->mesh(), triangles, {0, 0, 0.5}, 0.1), 0.1);
}

TEST(Inside, SurfacePointsLeaveNoHole) {
  constexpr double kSpacing = 0.004;
  const auto box = make_box({0.05, 0.04, 0.001});
  const std::vector<Eigen::Vector3d> points = surface_points(box->mesh(), kSpacing);
  for (const Eigen::Vector3d& p : points) EXPECT_NEAR(box->distance(p), 0, 1e-8);
  RandomStream random(3);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d on_top(random.uniform(-0.025, 0.025), random.uniform(-0.02, 0.02), 5e-4);
    double nearest = 1;
    for (const Eigen::Vector3d& p : points) nearest = std::min(nearest, (p - on_top).norm());
    EXPECT_LE(nearest, kSpacing);
  }
}

}  // namespace
}  // namespace graspdb
