// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "graspdb/renderer/renderer.h"
#include "renderer/shapes.h"

namespace graspdb {
namespace {

using testing::capsule;
using testing::joined;
using testing::sphere;

TEST(AmbientOpenness, ALoneConvexBodyIsWideOpen) {
  for (const float open : ambient_openness(sphere({0, 0, 0}, 0.05), nullptr, 16, 0.1)) {
    EXPECT_EQ(open, 1.0F);
  }
}

TEST(AmbientOpenness, ACreaseBetweenFingersIsDarkAndTheirBacksAreNot) {
  const Mesh left = capsule({-0.0105, 0, 0}, 0.01, 0.03),
             right = capsule({0.0105, 0, 0}, 0.01, 0.03);
  const std::vector<float> open = ambient_openness(joined(left, right), nullptr, 32, 0.03);
  for (std::size_t v = 0; v < left.vertices.size(); ++v) {
    if (std::abs(left.vertices[v].y()) > 0.031F) continue;
    if (left.normals[v].x() > 0.95F) {
      EXPECT_LT(open[v], 0.4F);
    }
    if (left.normals[v].x() < -0.3F) {
      EXPECT_EQ(open[v], 1.0F);
    }
  }
}

TEST(AmbientOpenness, AnInfiniteWallBesideAVertexHidesTheKnownShare) {
  // A flat vertex looks up at a big ball that covers the cone of half angle asin(r / d): it hides
  // sin^2 of that angle of the cosine-weighted sky.
  Mesh floor;
  floor.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  floor.normals.assign(3, {0, 0, 1});
  floor.vertices.push_back({0, 0, 0});
  floor.normals.push_back({0, 0, 1});
  floor.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Mesh ball = sphere({0, 0, 0.1}, 0.07, 192);
  EXPECT_NEAR(ambient_openness(floor, &ball, 2000, 1.0)[3], 1 - 0.49, 0.01);
  EXPECT_EQ(ambient_openness(floor, &ball, 2000, 0.02)[3], 1.0F);  // out of reach
}

}  // namespace
}  // namespace graspdb
