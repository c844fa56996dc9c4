// SPDX-License-Identifier: MIT
#include "graspdb/geometry/solid.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <tuple>

#include "graspdb/core/transform.h"
#include "support/closed_surface.h"

namespace graspdb {
namespace {

using Shapes = std::vector<std::shared_ptr<const Solid>>;

Shapes shapes() {
  return {make_sphere(0.067),
          make_cylinder(0.04, 0.2),
          make_cylinder(0.12, 0.002),
          make_box({0.23, 0.18, 0.028}),
          make_box({0.085, 0.054, 0.001}),
          make_ring(0.026, 0.007),
          scaled(make_cylinder(0.06, 0.1), 0.7)};
}

Eigen::Vector3d corner(const Mesh& mesh, const Triangle& triangle, std::size_t i) {
  return mesh.vertices[triangle[i]].cast<double>();
}

TEST(Solid, SphereDistances) {
  const auto ball = make_sphere(0.06);
  EXPECT_NEAR(ball->distance({0, 0, 0}), -0.03, 1e-15);
  EXPECT_NEAR(ball->distance({0.03, 0.04, 0}), 0.02, 1e-15);
  EXPECT_EQ(ball->half_extents(), Eigen::Vector3d(0.03, 0.03, 0.03));
}

TEST(Solid, CylinderDistances) {
  const auto pipe = make_cylinder(0.04, 0.2);
  EXPECT_NEAR(pipe->distance({0, 0, 0}), -0.02, 1e-15);
  EXPECT_NEAR(pipe->distance({0.03, 0.04, 0.05}), 0.03, 1e-15);   // beside the wall
  EXPECT_NEAR(pipe->distance({0.01, 0, 0.095}), -0.005, 1e-15);   // below the lid
  EXPECT_NEAR(pipe->distance({0, 0.023, -0.104}), 0.005, 1e-15);  // off the rim
  EXPECT_EQ(pipe->half_extents(), Eigen::Vector3d(0.02, 0.02, 0.1));
}

TEST(Solid, BoxDistances) {
  const auto box = make_box({0.2, 0.1, 0.04});
  EXPECT_NEAR(box->distance({0, 0, 0}), -0.02, 1e-15);
  EXPECT_NEAR(box->distance({0.11, 0, 0}), 0.01, 1e-15);
  EXPECT_NEAR(box->distance({0.103, 0.054, 0}), 0.005, 1e-15);         // off an edge
  EXPECT_NEAR(box->distance({-0.102, -0.053, -0.026}), 0.007, 1e-15);  // off a corner
  EXPECT_EQ(box->half_extents(), Eigen::Vector3d(0.1, 0.05, 0.02));
}

TEST(Solid, RingDistances) {
  const auto ring = make_ring(0.026, 0.006);  // the middle of the wire is 16 mm from the axis
  EXPECT_NEAR(ring->distance({0, 0, 0}), 0.013, 1e-15);
  EXPECT_NEAR(ring->distance({0, 0.016, 0}), -0.003, 1e-15);
  EXPECT_NEAR(ring->distance({-0.019, 0, 0.004}), 0.002, 1e-15);  // off the wire's outside
  EXPECT_NEAR(ring->distance({0, 0, 0.012}), 0.017, 1e-15);       // on the axis
  EXPECT_TRUE(ring->half_extents().isApprox(Eigen::Vector3d(0.019, 0.019, 0.003)));
}

TEST(Solid, ScaledMeasuresAsOneOfThatSize) {
  const auto pipe = make_cylinder(0.04, 0.2), half = scaled(make_cylinder(0.08, 0.4), 0.5);
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 0), {0.03, 0.04, 0.05}, {0.01, 0, 0.095}, {0, 0.023, -0.104}}) {
    EXPECT_NEAR(half->distance(p), pipe->distance(p), 1e-15);
  }
  EXPECT_EQ(half->half_extents(), pipe->half_extents());
  EXPECT_NEAR(testing::volume(half->mesh()), testing::volume(pipe->mesh()), 1e-9);
  EXPECT_THROW(scaled(pipe, 0), std::logic_error);
}

TEST(Solid, MeshVerticesLieOnTheSurface) {
  for (const auto& solid : shapes()) {
    for (const Eigen::Vector3f& v : solid->mesh().vertices) {
      EXPECT_NEAR(solid->distance(v.cast<double>()), 0, 1e-8);
    }
  }
}

TEST(Solid, MeshIsClosedByPosition) {
  using Point = std::tuple<float, float, float>;
  const auto point = [](const Eigen::Vector3f& v) { return Point(v.x(), v.y(), v.z()); };
  for (const auto& solid : shapes()) {
    const Mesh& mesh = solid->mesh();
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        ++edges[{point(mesh.vertices[t[i]]), point(mesh.vertices[t[(i + 1) % 3]])}];
      }
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
  }
}

TEST(Solid, MeshNormalsAreUnitAndPointOut) {
  constexpr double kStep = 1e-4;
  for (const auto& solid : shapes()) {
    const Mesh& mesh = solid->mesh();
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const Eigen::Vector3d normal = mesh.normals[v].cast<double>();
      EXPECT_NEAR(normal.norm(), 1, 1e-6);
      EXPECT_NEAR(solid->distance(mesh.vertices[v].cast<double>() + kStep * normal), kStep, 1e-7);
    }
    for (const Triangle& t : mesh.triangles) {
      const Eigen::Vector3d face =
          (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
      EXPECT_GT(face.normalized().dot(mesh.normals[t[0]].cast<double>()), 0.99);
    }
  }
}

TEST(Solid, MeshHoldsTheVolume) {
  EXPECT_NEAR(testing::volume(make_sphere(0.06)->mesh()) / (4.0 / 3 * kPi * 27e-6), 1, 0.006);
  EXPECT_NEAR(testing::volume(make_cylinder(0.04, 0.2)->mesh()) / (kPi * 4e-4 * 0.2), 1, 0.003);
  EXPECT_NEAR(testing::volume(make_ring(0.026, 0.006)->mesh()) / (2 * kPi * 0.016 * kPi * 9e-6), 1,
              0.02);
  EXPECT_NEAR(testing::volume(make_box({0.2, 0.1, 0.04})->mesh()), 8e-4, 1e-9);
}

TEST(Solid, ImpossibleSizeIsAFaultOfTheCaller) {
  EXPECT_THROW(make_sphere(0), std::logic_error);
  EXPECT_THROW(make_cylinder(0.1, -1), std::logic_error);
  EXPECT_THROW(make_box({1, 0, 1}), std::logic_error);
  EXPECT_THROW(make_ring(0.02, 0), std::logic_error);
}

}  // namespace
}  // namespace graspdb
