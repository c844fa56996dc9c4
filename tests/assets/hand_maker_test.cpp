// SPDX-License-Identifier: MIT
#include "graspdb/hand_maker.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "graspdb/error.h"
#include "graspdb/rig.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

// Made once for all tests.
const Hand& made_male() {
  static const Hand hand = make_hand(default_hand_shape("male"));
  return hand;
}

double worst_difference(const Skeleton& a, const Skeleton& b) {
  double worst = 0;
  for (std::size_t i = 0; i < kBoneCount; ++i) {
    const RigidTransform &p = a.palm_from_bone_at_zero[i], &q = b.palm_from_bone_at_zero[i];
    worst = std::max({worst, (p.rotation - q.rotation).cwiseAbs().maxCoeff(),
                      (p.translation - q.translation).cwiseAbs().maxCoeff()});
  }
  for (std::size_t i = 0; i < 5; ++i) {
    worst = std::max(worst, (a.tip_in_distal[i] - b.tip_in_distal[i]).cwiseAbs().maxCoeff());
  }
  return worst;
}

double worst_difference(const Mesh& a, const Mesh& b) {
  if (a.vertices.size() != b.vertices.size()) return 1e9;
  double worst = 0;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    worst = std::max<double>(worst, (a.vertices[v] - b.vertices[v]).cwiseAbs().maxCoeff());
  }
  return worst;
}

void expect_same_hand(const Hand& a, const Hand& b) {
  EXPECT_LT(worst_difference(a.skeleton, b.skeleton), 1e-6);
  EXPECT_LT(worst_difference(a.bind_mesh, b.bind_mesh), 1e-6);
  EXPECT_EQ(a.bind_mesh.triangles, b.bind_mesh.triangles);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const auto &p = a.palm_from_bone_at_bind[bone], &q = b.palm_from_bone_at_bind[bone];
    EXPECT_LT(angle_between(p.rotation, q.rotation), 3e-6) << bone_name(static_cast<int>(bone));
    EXPECT_LT((p.translation - q.translation).norm(), 1e-6) << bone_name(static_cast<int>(bone));
  }
}

TEST(HandMaker, SurfaceIsClosedAndOfOnePieceWithoutHandles) {
  const Mesh& mesh = made_male().bind_mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    volume += mesh.vertices[t[0]].cast<double>().dot(
                  mesh.vertices[t[1]].cast<double>().cross(mesh.vertices[t[2]].cast<double>())) /
              6;
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
  EXPECT_EQ(mesh.vertices.size() + mesh.triangles.size() - edges.size() / 2, 2);  // Euler
  EXPECT_GE(mesh.triangles.size(), 8000);
  EXPECT_LE(mesh.triangles.size(), 12000);
  EXPECT_GT(volume, 4e-4);  // cubic metres, with the forearm
  EXPECT_LT(volume, 1.2e-3);
}

TEST(HandMaker, WeightsAreSharesOfUpToFourBones) {
  for (const SkinWeights& skin : made_male().weights) {
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_GE(skin.weight[i], 0);
      ASSERT_LT(skin.bone[i], kBoneCount);
      sum += skin.weight[i];
    }
    ASSERT_NEAR(sum, 1, 1e-6);
  }
}

TEST(HandMaker, NormalsPointOutwards) {
  const Mesh& mesh = made_male().bind_mesh;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.vertices[t[0]];
    const Eigen::Vector3f face = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    ASSERT_GT(face.dot(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]), 0);
  }
}

TEST(HandMaker, WrittenHandIsLoadedAsItWasMade) {
  const testing::TemporaryDirectory directory;
  write_hand(made_male(), directory / "male.glb");
  const Hand loaded = load_hand(directory / "male.glb");
  EXPECT_EQ(loaded.name, "male");
  expect_same_hand(loaded, made_male());
  for (std::size_t v = 0; v < loaded.weights.size(); ++v) {
    PerBone<float> made{}, read{};
    for (std::size_t i = 0; i < 4; ++i) {
      made[made_male().weights[v].bone[i]] += made_male().weights[v].weight[i];
      read[loaded.weights[v].bone[i]] += loaded.weights[v].weight[i];
    }
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
      ASSERT_NEAR(made[bone], read[bone], 1e-6);
    }
  }
}

TEST(HandMaker, CommittedMaleHandIsTheOneThatIsMade) {
  expect_same_hand(load_hand(GRASPDB_SOURCE_DIR "/assets/hands/male.glb"), made_male());
}

TEST(HandMaker, RefusesAnUnknownDefaultHand) {
  EXPECT_THROW(default_hand_shape("giant"), Error);
}

}  // namespace
}  // namespace graspdb
