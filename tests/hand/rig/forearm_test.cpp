// SPDX-License-Identifier: MIT
#include "forearm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "glb_edit.h"
#include "graspdb/core/transform.h"
#include "rig_file.h"
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

// Closed at both ends, but for one triangle.
RigSkin with_hole(std::size_t triangle, int bone = kPalm) {
  RigSkin skin = capped(tube(0));
  skin.mesh.triangles.erase(skin.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(triangle));
  PerBone<double> weights{};
  weights[static_cast<std::size_t>(bone)] = 1;
  skin.weights.assign(skin.mesh.vertices.size(), weights);
  return skin;
}

TEST(Forearm, AHoleElsewhereIsNotItsEnd) {
  constexpr std::size_t kSide = 3, kTip = 8 * kSides + 1, kCap = 9 * kSides + 1;
  for (const std::size_t hole : {kSide, kTip, kCap}) {
    RigSkin skin = with_hole(hole);
    const Mesh before = skin.mesh;
    EXPECT_THAT(open_end(kElbow, skin).value_or("accepted"),
                ::testing::HasSubstr("an open loop of 3 edges on palm"))
        << hole;
    EXPECT_TRUE(skin.mesh.triangles == before.triangles);
  }
}

TEST(Forearm, AnEndThatAFingerMovesIsNone) {
  RigSkin skin = tube(0);
  PerBone<double> finger{};
  finger[finger_bone(0, kDistal)] = 1;
  skin.weights.assign(skin.mesh.vertices.size(), finger);
  EXPECT_THAT(open_end(kElbow, skin).value_or("accepted"),
              ::testing::HasSubstr("16 edges on index_distal"));
}

TEST(Forearm, AnEndBeforeTheWristOrBesideItsAxisIsNone) {
  for (const Eigen::Vector3f& by : {Eigen::Vector3f(0, .03F, 0), Eigen::Vector3f(.03F, 0, 0)}) {
    RigSkin skin = tube(0);
    for (Eigen::Vector3f& v : skin.mesh.vertices) v += by;
    EXPECT_TRUE(open_end(kElbow, skin).has_value()) << by.transpose();
  }
}

// The file that taught this: closed but for one triangle of the index fingertip.
TEST(Forearm, DoesNotGrowOutOfAFingertip) {
  testing::GlbEdit file;
  const RigFile male = read_rig_file(testing::kMale);
  const Eigen::Vector3f tip = male.joints.at("index_tip").cast<float>();
  const auto distance = [&](const Triangle& t) { return (male.mesh.vertices[t[0]] - tip).norm(); };
  const auto nearest = std::ranges::min_element(male.mesh.triangles, {}, distance);
  const auto number = static_cast<std::size_t>(nearest - male.mesh.triangles.begin());
  const std::size_t indices = file.json["meshes"][0]["primitives"][0]["indices"];
  const nlohmann::json& accessor = file.json["accessors"][indices];
  const std::size_t size = accessor["componentType"] == 5125 ? 4 : 2;
  const std::size_t view = accessor["bufferView"];
  const std::size_t from = file.json["bufferViews"][view].value("byteOffset", std::size_t{0});
  const std::size_t corner = from + 3 * size * number;
  file.binary.replace(corner, size, file.binary, corner + size, size);  // a corner twice: no area
  EXPECT_EQ(file.refusal(), "accepted");
  const std::string map =
      read_text(rig_map_beside(testing::kMale)) + "[forearm]\nextend_mm = 100\n";
  EXPECT_THAT(file.refusal(map),
              AllOf(::testing::HasSubstr("forearm.extend_mm"),
                    ::testing::HasSubstr("an open loop of 3 edges on index_distal")));
  EXPECT_EQ(testing::refusal_of(map), "accepted");
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
