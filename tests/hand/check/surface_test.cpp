// SPDX-License-Identifier: MIT
// Each line on the surface passes on the male hand and fails on one that was spoilt for it.
#include "surface.h"

#include <cmath>

#include "poses.h"
#include "spoilt_hands.h"

namespace graspdb::testing {
namespace {

TEST(HandCheckSurface, PassesOnAGoodHand) {
  for (const HandCheckLine& line : check_surface(male())) {
    EXPECT_EQ(line.status, Status::kPass) << line.name << " " << line.value;
  }
}

TEST(HandCheckSurface, AHoleIsOpenAndEnclosesNothing) {
  Hand hand = male();
  hand.bind_mesh.triangles.pop_back();
  const Lines lines = check_surface(hand);
  EXPECT_EQ(line_of(lines, "open edges").value, 3);
  expect_fail(lines, "open edges");
  expect_fail(lines, "Euler number");
  expect_not_applicable(lines, "volume", "open");
  for (const char* pose : {"flat", "wrap", "pinch", "fist", "limits of thumb"}) {
    expect_not_applicable(check_poses(hand), std::string("volume change, ") + pose, "open");
  }
}

TEST(HandCheckSurface, APieceApartIsNamed) {
  Hand hand = male();
  const auto first = static_cast<std::uint32_t>(hand.bind_mesh.vertices.size());
  for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    hand.bind_mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (const Eigen::Vector3f& corner :
       {Eigen::Vector3f(0, 0, .1F), {.01F, 0, .1F}, {0, .01F, .1F}, {0, 0, .11F}}) {
    hand.bind_mesh.vertices.push_back(corner);
    hand.bind_mesh.normals.push_back(Eigen::Vector3f::UnitZ());
    hand.weights.push_back(only(kThumbDistal));
  }
  const Lines lines = check_surface(hand);
  expect_pass(lines, "open edges");
  expect_fail(lines, "Euler number", "apart: 4 triangles on thumb_distal");
}

TEST(HandCheckSurface, ATriangleTooManyBranches) {
  Hand hand = male();
  hand.bind_mesh.triangles.push_back(hand.bind_mesh.triangles.front());
  expect_fail(check_surface(hand), "open edges");
}

TEST(HandCheckSurface, AFlippedTriangleTurnsItsThreeEdges) {
  Hand hand = male();
  std::swap(hand.bind_mesh.triangles[100][0], hand.bind_mesh.triangles[100][1]);
  const Lines lines = check_surface(hand);
  expect_pass(lines, "open edges");
  EXPECT_EQ(line_of(lines, "turned edges").value, 3);
  expect_fail(lines, "turned edges");
}

TEST(HandCheckSurface, InsideOutIsANegativeVolume) {
  Hand hand = male();
  for (Triangle& t : hand.bind_mesh.triangles) std::swap(t[0], t[1]);
  const Lines lines = check_surface(hand);
  expect_pass(lines, "turned edges");
  expect_fail(lines, "volume");
}

TEST(HandCheckSurface, TwoPiecesThatShareAVertexArePinched) {
  Hand hand = male();
  const std::uint32_t kept = hand.bind_mesh.triangles[0][0], joined = 3000;
  for (Triangle& t : hand.bind_mesh.triangles) std::replace(t.begin(), t.end(), joined, kept);
  const Lines lines = check_surface(hand);
  expect_pass(lines, "open edges");
  EXPECT_EQ(line_of(lines, "pinched vertices").value, 1);
  expect_fail(lines, "pinched vertices");
}

TEST(HandCheckSurface, ASecondPieceHasAnotherEulerNumber) {
  Hand hand = male();
  Mesh& mesh = hand.bind_mesh;
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<Triangle> triangles = mesh.triangles;
  for (const Triangle& t : triangles) {
    mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  for (std::uint32_t v = 0; v < count; ++v) {
    mesh.vertices.push_back(mesh.vertices[v]);
    hand.weights.push_back(hand.weights[v]);
  }
  const Lines lines = check_surface(hand);
  EXPECT_EQ(line_of(lines, "Euler number").value, 4);
  expect_fail(lines, "Euler number");
  expect_pass(lines, "open edges");
}

TEST(HandCheckSurface, TriangleQualityIsOneForEqualSidesAndSmallForASliver) {
  Hand hand;
  hand.bind_mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {.5f, std::sqrt(.75f), 0}};
  hand.bind_mesh.triangles = {{0, 1, 2}};
  hand.weights = {only(kPalm), only(kPalm), only(kPalm)};
  EXPECT_NEAR(line_of(check_surface(hand), "triangle quality").value, 1, 1e-6);
  hand.bind_mesh.vertices[2].y() = .01f;  // area .005, squared sides 1 + 2 (.25 + .0001)
  EXPECT_NEAR(line_of(check_surface(hand), "triangle quality").value,
              4 * std::sqrt(3.) * .005 / 1.5002, 1e-6);
  expect_fail(check_surface(hand), "triangle quality", "triangle 0 on palm");
}

// A vertex of the skin whose triangles lie at most, or at least, this far along y.
std::uint32_t vertex_where(const Hand& hand, const auto& is_wanted) {
  const auto& vertices = hand.bind_mesh.vertices;
  std::vector<bool> wanted(vertices.size(), true);
  for (const Triangle& t : hand.bind_mesh.triangles) {
    const bool all =
        std::all_of(t.begin(), t.end(), [&](auto v) { return is_wanted(vertices[v]); });
    for (const std::uint32_t v : t) wanted[v] = wanted[v] && all;
  }
  return static_cast<std::uint32_t>(std::find(wanted.begin(), wanted.end(), true) - wanted.begin());
}

TEST(HandCheckSurface, LongEdgesCountExceptOnTheForearmsCap) {
  float end = 0;
  for (const Eigen::Vector3f& v : male().bind_mesh.vertices) end = std::min(end, v.y());
  Hand long_on_cap = male(), long_on_arm = male();
  const auto on_cap = [&](const Eigen::Vector3f& v) { return v.y() < end + .0005f; };
  const auto on_arm = [&](const Eigen::Vector3f& v) { return v.y() > end + .05f; };
  const Eigen::Vector3f sideways(.03f, 0, 0);
  long_on_cap.bind_mesh.vertices[vertex_where(male(), on_cap)] += sideways;
  long_on_arm.bind_mesh.vertices[vertex_where(male(), on_arm)] += sideways;
  expect_pass(check_surface(long_on_cap), "longest edge");
  expect_fail(check_surface(long_on_arm), "longest edge", "triangle");
}

}  // namespace
}  // namespace graspdb::testing
