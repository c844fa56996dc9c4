// SPDX-License-Identifier: MIT
#include "graspdb/geometry/triangle.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

const Corners kRight = {Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 3, 0)};

Vector3d drawn(RandomStream& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

Corners drawn_triangle(RandomStream& random) {
  return {drawn(random), drawn(random), drawn(random)};
}

TEST(Triangle, CornersAreThoseOfItsMesh) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  EXPECT_EQ(corners_of(mesh, {3, 1, 2}),
            (Corners{Vector3d(0, 0, 3), Vector3d(1, 0, 0), Vector3d(0, 2, 0)}));
}

TEST(Triangle, NormalIsTwiceTheAreaAndSeesItsCornersCounterClockwise) {
  EXPECT_EQ(normal_of(kRight), Vector3d(0, 0, 12));
  EXPECT_EQ(longest_side(kRight), 5);
}

TEST(Triangle, QualityIsOneForEqualSidesAndNothingWithoutAnArea) {
  const Corners equal = {Vector3d(0, 0, 0), Vector3d(2, 0, 0), Vector3d(1, std::sqrt(3.), 0)};
  EXPECT_NEAR(quality_of(equal), 1, 1e-15);
  EXPECT_NEAR(quality_of(kRight), 2 * std::sqrt(3.) * 12 / 50, 1e-15);
  EXPECT_EQ(quality_of({kRight[0], kRight[1], kRight[1]}), 0);
  EXPECT_EQ(quality_of({kRight[0], kRight[0], kRight[0]}), 0);
}

TEST(Triangle, ASegmentEndsAtItsEnds) {
  const Vector3d a(0, 0, 0), b(2, 0, 0);
  EXPECT_EQ(share_of_way({.5, 3, 0}, a, b), .25);
  EXPECT_EQ(share_of_way({-4, 3, 0}, a, b), 0);
  EXPECT_EQ(share_of_way({5, 0, 4}, a, b), 1);
  EXPECT_EQ(share_of_way({0, 3, 4}, a, a), 0);
  EXPECT_EQ(distance_to_segment({1, 3, 0}, a, b), 3);
  EXPECT_EQ(distance_to_segment({-4, 3, 0}, a, b), 5);
  EXPECT_EQ(distance_to_segment({5, 0, 4}, a, b), 5);
  EXPECT_EQ(distance_to_segment({0, 3, 4}, a, a), 5);
}

TEST(Triangle, ItsDistanceIsTheLeastToItsPoints) {
  RandomStream random(1);
  for (int i = 0; i < 50; ++i) {
    const Corners t = drawn_triangle(random);
    const Vector3d point = 2 * drawn(random);
    double least = std::numeric_limits<double>::infinity();
    constexpr int kFine = 200;
    for (int u = 0; u <= kFine; ++u) {
      for (int v = 0; u + v <= kFine; ++v) {
        const Vector3d on = t[0] + (t[1] - t[0]) * u / kFine + (t[2] - t[0]) * v / kFine;
        least = std::min(least, (on - point).norm());
      }
    }
    EXPECT_NEAR(distance_to_triangle(point, t), least, .02);
    EXPECT_LE(distance_to_triangle(point, t), least + 1e-12);
  }
}

TEST(Triangle, WithoutAnAreaItIsItsLongestSide) {
  RandomStream random(2);
  for (int i = 0; i < 50; ++i) {
    const Vector3d a = drawn(random), b = drawn(random), point = 2 * drawn(random);
    const double expected = distance_to_segment(point, a, b);
    EXPECT_NEAR(distance_to_triangle(point, {a, b, b}), expected, 1e-15);
    EXPECT_NEAR(distance_to_triangle(point, {a, a, b}), expected, 1e-15);
    EXPECT_NEAR(distance_to_triangle(point, {a, a, a}), (point - a).norm(), 1e-15);
  }
}

TEST(Triangle, ItsNearestPointIsAsFarAsTheTriangle) {
  RandomStream random(3);
  for (int i = 0; i < 5000; ++i) {
    const Corners t = drawn_triangle(random);
    const Vector3d point = 2 * drawn(random);
    const Vector3d nearest = nearest_on_triangle(point, t).point;
    EXPECT_NEAR((nearest - point).norm(), distance_to_triangle(point, t), 1e-9);
    EXPECT_NEAR(distance_to_triangle(nearest, t), 0, 1e-9);
  }
}

TEST(Triangle, SaysOnWhatPartItIsNearest) {
  using Nearest = NearestOnTriangle;
  const struct {
    Vector3d from, nearest;
    Nearest::Part part;
  } cases[] = {
      {{-1, -1, 5}, {0, 0, 0}, Nearest::kCornerA},  {{6, -1, 5}, {4, 0, 0}, Nearest::kCornerB},
      {{-1, 6, 5}, {0, 3, 0}, Nearest::kCornerC},   {{2, -1, 5}, {2, 0, 0}, Nearest::kEdgeAb},
      {{5, 5.5, 5}, {2, 1.5, 0}, Nearest::kEdgeBc}, {{-1, 1, 5}, {0, 1, 0}, Nearest::kEdgeCa},
      {{1, 1, -5}, {1, 1, 0}, Nearest::kInside},
  };
  for (const auto& [from, nearest, part] : cases) {
    const Nearest found = nearest_on_triangle(from, kRight);
    EXPECT_LT((found.point - nearest).norm(), 1e-15);
    EXPECT_EQ(found.part, part);
  }
}

TEST(Triangle, ARayMeetsTheNearestOneBeforeIt) {
  const auto across = [](double z) {
    return Corners{Vector3d(-1, -1, z), Vector3d(1, -1, z), Vector3d(0, 1, z)};
  };
  const std::array<Corners, 3> all = {across(5), across(-1), across(2)};
  EXPECT_EQ(distance_along(Vector3d::Zero(), Vector3d::UnitZ(), all), 2);
  EXPECT_EQ(distance_along(Vector3d::Zero(), -Vector3d::UnitZ(), all), 1);
  EXPECT_EQ(distance_along({3, 0, 0}, Vector3d::UnitZ(), all), std::nullopt);
  EXPECT_EQ(distance_along(Vector3d::Zero(), Vector3d::UnitX(), all), std::nullopt);
  EXPECT_EQ(distance_along(Vector3d::Zero(), Vector3d::UnitZ(), {}), std::nullopt);
}

// The ray's and the triangle's plane as three equations: a + u ab + v ac = origin + distance way.
TEST(Triangle, RaysMeetWhatTheEquationsSay) {
  RandomStream random(4);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::array<Corners, 1> t = {drawn_triangle(random)};
    const Vector3d origin = drawn(random), way = drawn(random).normalized();
    Eigen::Matrix3d equations;
    equations << t[0][1] - t[0][0], t[0][2] - t[0][0], -way;
    const Vector3d solved = equations.fullPivLu().solve(origin - t[0][0]);
    const double u = solved[0], v = solved[1], distance = solved[2];
    const bool meets = u >= 0 && v >= 0 && u + v <= 1 && distance > 0;
    const std::optional<double> found = distance_along(origin, way, t);
    ASSERT_EQ(found.has_value(), meets);
    EXPECT_NEAR(found.value_or(0), meets ? distance : 0, 1e-9);
    met += meets;
  }
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace graspdb
