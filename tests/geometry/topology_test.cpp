// SPDX-License-Identifier: MIT
#include "graspdb/geometry/topology.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "graspdb/core/random.h"
#include "graspdb/geometry/solid.h"
#include "support/closed_surface.h"

namespace graspdb {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

// `mesh` and `part` beside each other.
Mesh together(Mesh mesh, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const Triangle& t : part.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

bool is_sphere_like(const Mesh& mesh) {
  return graspdb::is_sphere_like(mesh.vertices.size(), mesh.triangles);
}

std::vector<Triangle> drawn_triangles(RandomStream& random, std::size_t count,
                                      std::uint64_t vertices) {
  std::vector<Triangle> triangles;
  while (triangles.size() < count) {
    Triangle t;
    for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random.below(vertices));
    if (has_three_corners(t)) triangles.push_back(t);
  }
  return triangles;
}

TEST(Topology, EveryEdgeIsVisitedOnceInOrderWithAllItsSides) {
  RandomStream random(1);
  const std::vector<Triangle> triangles = drawn_triangles(random, 200, 20);
  std::pair<std::uint32_t, std::uint32_t> last = {0, 0};
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;  // triangle, corner
  for_each_edge(triangles, [&](Edge edge) {
    const std::pair here(edge.front().low, edge.front().high);
    EXPECT_GT(here, last);
    last = here;
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const TriangleSide& side = edge[i];
      EXPECT_TRUE(i == 0 || side.triangle > edge[i - 1].triangle);
      const std::uint32_t from = triangles[side.triangle][side.corner];
      const std::uint32_t to = triangles[side.triangle][(side.corner + 1) % 3];
      EXPECT_EQ(here, std::pair(std::min(from, to), std::max(from, to)));
      EXPECT_EQ(side.upwards, from < to);
      EXPECT_TRUE(seen.emplace(side.triangle, side.corner).second);
    }
  });
  EXPECT_EQ(seen.size(), 3 * triangles.size());
}

TEST(Topology, EdgesAreCountedAsByLookingThroughAllTriangles) {
  RandomStream random(2);
  for (const std::size_t count : {0, 1, 5, 20, 60}) {
    const std::vector<Triangle> triangles = drawn_triangles(random, count, 12);
    EdgeCounts expected;
    for (std::uint32_t low = 0; low < 12; ++low) {
      for (std::uint32_t high = low + 1; high < 12; ++high) {
        int up = 0, down = 0;
        for (const Triangle& t : triangles) {
          for (std::size_t i = 0; i < 3; ++i) {
            up += t[i] == low && t[(i + 1) % 3] == high;
            down += t[i] == high && t[(i + 1) % 3] == low;
          }
        }
        expected.all += up + down > 0;
        expected.open += up + down == 1;
        expected.crowded += up + down > 2;
        expected.turned += up + down == 2 && up != 1;
      }
    }
    const EdgeCounts found = count_edges(triangles);
    EXPECT_EQ(found.all, expected.all);
    EXPECT_EQ(found.open, expected.open);
    EXPECT_EQ(found.crowded, expected.crowded);
    EXPECT_EQ(found.turned, expected.turned);
  }
}

TEST(Topology, ASurfaceIsClosedUntilATriangleIsMissingOrTwice) {
  Mesh mesh = tetrahedron();
  EXPECT_TRUE(is_closed(mesh.triangles));
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_TRUE(is_closed(mesh.triangles));
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_FALSE(is_closed(mesh.triangles));
  mesh.triangles.resize(3);
  EXPECT_FALSE(is_closed(mesh.triangles));
}

TEST(Topology, BallsAndBoxesAreLikeASphere) {
  EXPECT_TRUE(is_sphere_like(tetrahedron()));
  EXPECT_TRUE(is_sphere_like(welded(make_sphere(1)->mesh())));
  EXPECT_TRUE(is_sphere_like(welded(make_box({1, 2, 3})->mesh())));
}

TEST(Topology, HandlesPiecesHolesAndTurnedTrianglesAreNotLikeASphere) {
  EXPECT_FALSE(is_sphere_like(make_ring(1, .1)->mesh()));
  EXPECT_FALSE(is_sphere_like(Mesh()));
  Mesh mesh = tetrahedron();
  EXPECT_FALSE(is_sphere_like(together(mesh, mesh)));
  // A ring and a ball have together the Euler number of one ball.
  EXPECT_FALSE(is_sphere_like(together(make_ring(1, .1)->mesh(), mesh)));
  mesh.vertices.emplace_back(5, 5, 5);
  EXPECT_FALSE(is_sphere_like(mesh));
  mesh = tetrahedron();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_FALSE(is_sphere_like(mesh));
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_sphere_like(mesh));
}

TEST(Topology, NeighborsShareAnEdge) {
  const Mesh mesh = welded(make_box({1, 2, 3})->mesh());
  std::vector<std::set<std::uint32_t>> expected(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      for (const std::uint32_t other : t) {
        if (other != v) expected[v].insert(other);
      }
    }
  }
  const auto found = vertex_neighbors(mesh.vertices.size(), mesh.triangles);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_EQ(std::set(found[v].begin(), found[v].end()), expected[v]);
    EXPECT_EQ(found[v].size(), expected[v].size());
  }
}

TEST(Topology, WeldingJoinsWhatLiesAtOnePlace) {
  const Mesh box = welded(make_box({1, 2, 3})->mesh());
  EXPECT_EQ(box.vertices.size(), 8);
  EXPECT_EQ(box.triangles.size(), 12);
  EXPECT_TRUE(testing::is_closed_surface(box));
  EXPECT_EQ(welded(box).triangles, box.triangles);
}

TEST(Topology, WeldingDropsTrianglesThatLoseACorner) {
  Mesh mesh = tetrahedron();
  mesh.vertices[3] = {1, 0, 0};  // on another one
  const Mesh flat = welded(mesh);
  EXPECT_EQ(flat.vertices.size(), 3);
  EXPECT_EQ(flat.triangles, (std::vector<Triangle>{{0, 2, 1}, {0, 1, 2}}));
}

TEST(Topology, VolumeIsThatOfTheSolidAndNegativeInsideOut) {
  EXPECT_NEAR(volume_of(tetrahedron()), 1, 1e-6);  // a sixth of its box
  Mesh box = make_box({1, 2, 3})->mesh();
  EXPECT_NEAR(volume_of(box), 6, 1e-6);
  for (Eigen::Vector3f& v : box.vertices) v += Eigen::Vector3f(5, -3, 2);
  EXPECT_NEAR(volume_of(box), 6, 1e-5);
  for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(volume_of(box), -6, 1e-5);
}

}  // namespace
}  // namespace graspdb
