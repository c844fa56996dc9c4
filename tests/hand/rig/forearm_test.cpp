// SPDX-License-Identifier: MIT
#include "forearm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "graspdb/core/transform.h"
#include "support/closed_surface.h"

namespace graspdb {
namespace {

constexpr std::uint32_t kSides = 16;
constexpr double kRadius = .025;
const Eigen::Vector3d kElbow(0, -1, 0);

// A tube along y whose end at y = -0.02 may lean; the distal end is closed by a fan.
RigSkin tube(double slant) {
  RigSkin skin;
  Mesh& mesh = skin.mesh;
  for (int ring = 0; ring < 5; ++ring) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 2 * kPi * i / kSides;
      const Eigen::Vector3d out(std::cos(angle), 0, std::sin(angle));
      const double y = -.02 + .01 * ring + slant * out.z() * (4 - ring) / 4;
      mesh.vertices.push_back((kRadius * out + Eigen::Vector3d(0, y, 0)).cast<float>());
    }
  }
  for (std::uint32_t v = 0; v < 4 * kSides; ++v) {
    const std::uint32_t next = v % kSides == kSides - 1 ? v + 1 - kSides : v + 1;
    mesh.triangles.push_back({v, v + kSides, next});
    mesh.triangles.push_back({next, v + kSides, next + kSides});
  }
  mesh.vertices.push_back({0, .02F, 0});
  for (std::uint32_t i = 0; i < kSides; ++i) {
    mesh.triangles.push_back({4 * kSides + i, 5 * kSides, 4 * kSides + (i + 1) % kSides});
  }
  mesh.normals.assign(mesh.vertices.size(), Eigen::Vector3f::UnitZ());
  mesh.albedo.assign(mesh.vertices.size(), 1);
  PerBone<double> palm{};
  palm[kPalm] = 1;
  skin.weights.assign(mesh.vertices.size(), palm);
  return skin;
}

RigSkin capped(RigSkin skin) {
  skin.mesh.vertices.push_back({0, -.02F, 0});
  const auto center = static_cast<std::uint32_t>(skin.mesh.vertices.size() - 1);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    skin.mesh.triangles.push_back({center, i, (i + 1) % kSides});
  }
  skin.mesh.normals.push_back(Eigen::Vector3f::UnitZ());
  skin.mesh.albedo.push_back(1);
  skin.weights.push_back(skin.weights.front());
  return skin;
}

double reach(const RigSkin& skin) {
  double furthest = 0;
  for (const Eigen::Vector3f& v : skin.mesh.vertices) {
    furthest = std::max(furthest, v.cast<double>().dot(kElbow));
  }
  return furthest;
}

class Extended : public ::testing::TestWithParam<std::pair<bool, double>> {};

TEST_P(Extended, ForearmIsLongerAndClosed) {
  const auto& [closed, slant] = GetParam();
  RigSkin skin = closed ? capped(tube(slant)) : tube(slant);
  ASSERT_EQ(open_end(kElbow, skin), std::nullopt);
  extend_forearm(.1, kElbow, skin);
  EXPECT_NEAR(reach(skin), .12, 1e-6);
  EXPECT_TRUE(testing::is_closed_surface(skin.mesh));
  // A cone that widens by .075 of its length, after a straight tube.
  const double r = kRadius, wide = kRadius + .0075;
  const double polygon = kSides * std::sin(2 * kPi / kSides) / 2;  // of a circle's pi
  const double expected = polygon * (.04 * r * r + .1 * (r * r + r * wide + wide * wide) / 3);
  EXPECT_NEAR(testing::volume(skin.mesh), expected, expected * .02);
  EXPECT_EQ(skin.weights.size(), skin.mesh.vertices.size());
  EXPECT_EQ(skin.mesh.normals.size(), skin.mesh.vertices.size());
  EXPECT_EQ(skin.mesh.albedo.size(), skin.mesh.vertices.size());
}

TEST_P(Extended, NewNormalsPointAwayFromTheAxis) {
  const auto& [closed, slant] = GetParam();
  RigSkin skin = closed ? capped(tube(slant)) : tube(slant);
  ASSERT_EQ(open_end(kElbow, skin), std::nullopt);
  extend_forearm(.1, kElbow, skin);
  for (std::size_t v = 0; v < skin.mesh.vertices.size(); ++v) {
    const Eigen::Vector3f& place = skin.mesh.vertices[v];
    if (place.y() > -.03) continue;
    const Eigen::Vector3f out = Eigen::Vector3f(place.x(), 0, place.z()).normalized();
    const bool is_center = std::hypot(place.x(), place.z()) < 1e-3;
    EXPECT_GT(skin.mesh.normals[v].dot(is_center ? kElbow.cast<float>() : out), .97);
  }
}

INSTANTIATE_TEST_SUITE_P(Ends, Extended,
                         ::testing::Values(std::pair{true, 0.}, std::pair{false, 0.},
                                           std::pair{true, .004}, std::pair{false, .004}));

TEST(Forearm, AnEndWithTwoHolesIsRefusedAndStaysAsItIs) {
  RigSkin skin = tube(0);
  skin.mesh.triangles.pop_back();
  const Mesh before = skin.mesh;
  EXPECT_TRUE(open_end(kElbow, skin).has_value());
  EXPECT_TRUE(skin.mesh.triangles == before.triangles);
  EXPECT_TRUE(skin.mesh.vertices == before.vertices);
}

TEST(Forearm, SplitGivesHalfAtTheGivenPlaceAndAllBeyond) {
  RigSkin skin = tube(0);
  split_forearm({.at = .01, .width = .02}, kElbow, skin);
  for (std::size_t v = 0; v < skin.weights.size(); ++v) {
    const double beyond = -skin.mesh.vertices[v].y();
    const double expected = beyond > .015 ? 1 : beyond > .005 ? .5 : 0;
    EXPECT_NEAR(skin.weights[v][kForearm], expected, 1e-6) << beyond;
    EXPECT_NEAR(skin.weights[v][kPalm], 1 - expected, 1e-6) << beyond;
  }
}

}  // namespace
}  // namespace graspdb
