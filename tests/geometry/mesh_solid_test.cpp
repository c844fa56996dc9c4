// SPDX-License-Identifier: MIT
#include "graspdb/geometry/mesh_solid.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/random.h"
#include "graspdb/geometry/inside.h"
#include "graspdb/geometry/mesh_distance.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path kMug = GRASPDB_SOURCE_DIR "/assets/objects/mug.obj";

Eigen::Vector3d random_point(RandomStream& random, const Eigen::Vector3d& reach) {
  return {random.uniform(-reach.x(), reach.x()), random.uniform(-reach.y(), reach.y()),
          random.uniform(-reach.z(), reach.z())};
}

// A tetrahedron with its doors open for damage.
Mesh tiny_tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {0.02F, 0, 0}, {0, 0.02F, 0}, {0, 0, 0.02F}};
  mesh.normals.assign(4, Eigen::Vector3f::UnitX());
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

std::string refusal(const Mesh& mesh) {
  try {
    make_mesh_solid(mesh, "bad.obj");
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("bad.obj"));
    return error.what();
  }
  return "accepted";
}

void append(const Mesh& part, const Eigen::Vector3f& at, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3f& v : part.vertices) mesh.vertices.push_back(v + at);
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
  for (const Triangle& t : part.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

// By how much distances of a mesh differ from what `truth` says, metres.
struct Differences {
  double worst_near = 0, worst_beyond = 0, mean_beyond = 0;
  int wrong_signs = 0;
};
template <typename Truth>
Differences differences(const Solid& solid, double margin, int points, const Truth& truth) {
  constexpr double kNear = 3e-3, kFacets = 0.1e-3;
  RandomStream random(5);
  Differences found;
  int beyond = 0;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d p =
        random_point(random, solid.half_extents() + Eigen::Vector3d::Constant(margin));
    const double expected = truth(p), distance = solid.distance(p);
    const double off = std::abs(distance - expected);
    if (std::abs(expected) > kFacets && (distance < 0) != (expected < 0)) ++found.wrong_signs;
    if (std::abs(expected) < kNear) {
      found.worst_near = std::max(found.worst_near, off);
    } else {
      found.worst_beyond = std::max(found.worst_beyond, off);
      found.mean_beyond += off;
      ++beyond;
    }
  }
  found.mean_beyond /= beyond;
  return found;
}

void expect_small(const Differences& found, double facets) {
  EXPECT_LT(found.worst_near, 0.1e-3 + facets);
  EXPECT_LT(found.mean_beyond, 0.3e-3);
  EXPECT_LT(found.worst_beyond, 4e-3);
  EXPECT_EQ(found.wrong_signs, 0);
}

TEST(MeshSolid, OfAPrimitiveHasItsDistances) {
  constexpr double kFacets = 0.05e-3;  // metres that flat triangles lie below the round surface
  for (const auto& solid : {make_sphere(0.03), make_cylinder(0.02, 0.04),
                            make_box({0.03, 0.02, 0.004}), make_ring(0.024, 0.006)}) {
    const auto mesh = make_mesh_solid(solid->mesh(), "primitive");
    EXPECT_TRUE(mesh->half_extents().isApprox(solid->half_extents(), 1e-3));
    const auto truth = [&](const Eigen::Vector3d& p) { return solid->distance(p); };
    for (const double margin : {3e-3, 0.1}) {
      expect_small(differences(*mesh, margin, 4000, truth), kFacets);
    }
  }
}

TEST(MeshSolid, ExactDistancesOfABoxAreThoseOfTheSolid) {
  const auto box = make_box({0.03, 0.02, 0.004});
  Mesh welded;
  for (int i = 0; i < 8; ++i) {
    welded.vertices.emplace_back((i & 1) != 0 ? 0.015F : -0.015F, (i & 2) != 0 ? 0.01F : -0.01F,
                                 (i & 4) != 0 ? 0.002F : -0.002F);
  }
  welded.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const MeshDistance exact(welded);
  RandomStream random(6);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d p = random_point(random, {0.03, 0.02, 0.008});
    EXPECT_NEAR(exact.nearest(p).distance, box->distance(p), 1e-8);
    EXPECT_NEAR(exact.nearest(p, std::abs(box->distance(p)) + 1e-6).distance, box->distance(p),
                1e-8);
  }
}

class Mug : public ::testing::Test {
 protected:
  static const Solid& solid() {
    static const std::shared_ptr<const Solid> mug = load_mesh_solid(kMug, 1e-3);
    return *mug;
  }
  static double by_brute_force(const Eigen::Vector3d& p) {
    const Mesh& mesh = solid().mesh();
    const double away = distance_to_triangles(mesh, mesh.triangles, p, 1);
    return winding_number(mesh, mesh.triangles, p) > 0.5 ? -away : away;
  }
};

TEST_F(Mug, HasTheSizeItsManifestSays) {
  const Eigen::Vector3d size = 2000 * solid().half_extents();
  EXPECT_NEAR(size.z(), 95, 0.1);
  EXPECT_NEAR(size.y(), 80, 0.2);
  EXPECT_GT(size.x(), 105);
}

TEST_F(Mug, DistancesAreThoseOfBruteForce) {
  for (const double margin : {3e-3, 0.08}) {
    expect_small(differences(solid(), margin, 400, by_brute_force), 0);
  }
}

TEST_F(Mug, IsHollowAndHasAHandle) {
  const double handle = solid().half_extents().x();                   // the handle points along x
  EXPECT_GT(solid().distance({-handle + 0.04, 0, 0.01}), 0.03);       // in the coffee
  EXPECT_LT(solid().distance({-handle + 0.04, 0, -0.0455}), -0.001);  // in the bottom
  EXPECT_GT(solid().distance({handle - 0.016, 0, 0}), 0.003);         // where fingers go through
  EXPECT_LT(solid().distance({handle - 0.004, 0, 0}), -0.002);        // in the handle
}

TEST(MeshSolid, FingerRingsAreTwoHolesOfTheirSize) {
  const auto rings = load_mesh_solid(GRASPDB_SOURCE_DIR "/assets/objects/finger_rings.obj", 1e-3);
  EXPECT_NEAR(rings->half_extents().y(), 0.045, 1e-4);
  for (const double y : {-0.024, 0.024}) {
    EXPECT_GT(rings->distance({0, y, 0}), 0.011);
    EXPECT_NEAR(rings->distance({0.0135, y, 0}), 0.0005, 1e-4);
  }
  EXPECT_LT(rings->distance({0, 0, 0}), -0.001);  // where they are joined
}

// A ball of 30 mm with two triangles for each of its `steps` x `steps` parts, without doubled
// vertices.
Mesh fine_ball(std::uint32_t steps) {
  Mesh ball;
  const auto place = [&](double turn, double height) {
    const double across = std::sqrt(1 - height * height);
    const Eigen::Vector3d out(across * std::cos(turn), across * std::sin(turn), height);
    ball.vertices.push_back((0.015 * out).cast<float>());
    ball.normals.push_back(out.cast<float>());
  };
  for (std::uint32_t row = 1; row < steps; ++row) {
    for (std::uint32_t i = 0; i < steps; ++i) {
      place(2 * M_PI * i / steps, std::cos(M_PI * row / steps));
    }
  }
  place(0, 1);
  place(0, -1);
  const auto last = static_cast<std::uint32_t>(ball.vertices.size() - 1);
  for (std::uint32_t i = 0; i < steps; ++i) {
    const std::uint32_t next = (i + 1) % steps, bottom = (steps - 2) * steps;
    ball.triangles.push_back({last - 1, i, next});
    ball.triangles.push_back({last, bottom + next, bottom + i});
    for (std::uint32_t up = 0; up < bottom; up += steps) {
      ball.triangles.push_back({up + i, up + steps + i, up + steps + next});
      ball.triangles.push_back({up + i, up + steps + next, up + next});
    }
  }
  return ball;
}

TEST(LargeMesh, DistancesAreThoseOfTheBallNearAndFar) {
  const auto solid = make_mesh_solid(fine_ball(250), "ball");
  ASSERT_GT(solid->mesh().triangles.size(), 100000);
  const auto truth = [](const Eigen::Vector3d& p) { return p.norm() - 0.015; };
  for (const double margin : {3e-3, 0.03, 0.3}) {
    expect_small(differences(*solid, margin, 4000, truth), 0);
  }
}

TEST(LargeMesh, RefusesMoreThanTwoMillionTriangles) {
  Mesh mesh = tiny_tetrahedron();
  mesh.triangles.resize(2000001, {0, 1, 2});
  EXPECT_THAT(refusal(mesh), HasSubstr("found 2000001"));
}

TEST(LargeMesh, IsReadFromAFileWithNormalsThatPointOutwards) {
  const testing::TemporaryDirectory folder;
  const Mesh ball = fine_ball(330);
  std::string text;
  for (const Eigen::Vector3f& v : ball.vertices)
    text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const Triangle& t : ball.triangles)
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  write_text(folder / "ball.obj", text);
  const Mesh read = load_mesh_solid(folder / "ball.obj", 1)->mesh();
  EXPECT_EQ(read.vertices.size(), ball.vertices.size());
  ASSERT_EQ(read.triangles.size(), ball.triangles.size());
  ASSERT_EQ(read.normals.size(), read.vertices.size());
  for (std::size_t v = 0; v < read.vertices.size(); ++v) {
    ASSERT_LT((read.normals[v] - read.vertices[v].normalized()).norm(), 0.02) << v;
  }
}

TEST(MeshSolid, ItsMiddleIsTheOrigin) {
  Mesh ball;
  append(make_sphere(0.03)->mesh(), {0.4F, -0.1F, 0.2F}, ball);
  const auto solid = make_mesh_solid(ball, "ball");
  EXPECT_NEAR(solid->distance({0.016, 0, 0}), 0.001, 1e-4);
  EXPECT_NEAR(solid->distance({0, 0, -0.014}), -0.001, 1e-4);
  EXPECT_NEAR(solid->mesh().vertices.front().norm(), 0.015, 1e-6);
}

TEST(MeshSolid, RefusesOpenSurfacesAndSaysHowOpen) {
  EXPECT_EQ(refusal(tiny_tetrahedron()), "accepted");
  Mesh open = tiny_tetrahedron();
  open.triangles.pop_back();
  EXPECT_THAT(refusal(open), HasSubstr("expected a watertight surface, found 3 open edges"));
}

TEST(MeshSolid, RefusesTrianglesThatFaceTheWrongWay) {
  Mesh mesh = tiny_tetrahedron();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);
  EXPECT_THAT(refusal(mesh), HasSubstr("3 edges where they disagree"));
  mesh = tiny_tetrahedron();
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(refusal(mesh), HasSubstr("inside out"));
}

TEST(MeshSolid, SaysWhichTrianglesAreThereTwice) {
  Mesh doubled = tiny_tetrahedron();
  doubled.triangles.push_back({3, 0, 1});
  doubled.triangles.push_back({0, 2, 1});
  EXPECT_THAT(refusal(doubled), HasSubstr("every triangle once, found 2 that are there again"));
  Mesh two_sided = tiny_tetrahedron();
  for (const Triangle& t : tiny_tetrahedron().triangles)
    two_sided.triangles.push_back({t[0], t[2], t[1]});
  EXPECT_THAT(refusal(two_sided), HasSubstr("found 4 that are there again"));
  // A sheet that is drawn from both sides has no edge with more than two triangles too many.
  Mesh sheet = tiny_tetrahedron();
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 2, 3}, {1, 3, 2}};
  EXPECT_THAT(refusal(sheet), HasSubstr("found 2 that are there again"));
}

TEST(MeshSolid, SaysAtHowManyEdgesPartsTouch) {
  // Two tetrahedra that share an edge.
  Mesh touching = tiny_tetrahedron();
  touching.vertices.insert(touching.vertices.end(), {{0, -0.02F, 0}, {0.01F, -0.01F, -0.02F}});
  touching.normals.assign(6, Eigen::Vector3f::UnitX());
  for (const Triangle t :
       {Triangle{0, 1, 4}, Triangle{0, 5, 1}, Triangle{0, 4, 5}, Triangle{1, 5, 4}})
    touching.triangles.push_back(t);
  EXPECT_THAT(refusal(touching), HasSubstr("1 edges with more"));
}

TEST(MeshSolid, RefusesPiecesThatCutEachOtherButNotPiecesApart) {
  const Mesh ball = make_sphere(0.03)->mesh();
  Mesh two = ball;
  append(ball, {0.04F, 0, 0}, two);
  EXPECT_EQ(refusal(two), "accepted");
  Mesh cut = ball;
  append(ball, {0.01F, 0, 0}, cut);
  EXPECT_THAT(refusal(cut), HasSubstr("does not cut itself"));
}

TEST(MeshSolid, RefusesWhatCannotBeHeldAtItsUnit) {
  EXPECT_THROW(load_mesh_solid(kMug, 1), Error);
  try {
    load_mesh_solid(kMug, 1);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("is its unit right?"));
  }
  EXPECT_THAT(refusal({}), HasSubstr("a surface of triangles"));
}

TEST(MeshSolid, RefusesWhatIsNoMesh) {
  const testing::TemporaryDirectory folder;
  write_text(folder / "not.obj", "a poem\n");
  EXPECT_THROW(load_mesh_solid(folder / "not.obj", 1), Error);
  EXPECT_THROW(load_mesh_solid(folder / "absent.obj", 1), Error);
}

}  // namespace
}  // namespace graspdb
