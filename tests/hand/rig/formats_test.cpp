// SPDX-License-Identifier: MIT
// The same hand in the formats that people have, written by assimp.
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>

#include "graspdb/hand/named_poses.h"
#include "rig_maps.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

using testing::kMale;
using testing::TemporaryDirectory;

void export_male(const std::string& format, const std::filesystem::path& path) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(kMale.string(), 0);
  ASSERT_NE(scene, nullptr);
  Assimp::Exporter exporter;
  EXPECT_EQ(exporter.Export(scene, format, path.string()), aiReturn_SUCCESS);
}

struct Format {
  std::string id, extension;
};

class Formats : public ::testing::TestWithParam<Format> {};

TEST_P(Formats, GiveTheSameJointsAndTheSameSkinInEveryPose) {
  const TemporaryDirectory directory;
  const auto path = directory / ("male" + GetParam().extension);
  export_male(GetParam().id, path);
  const Hand male = load_hand(kMale), hand = load_hand(path, rig_map_beside(kMale));
  EXPECT_LT(testing::largest_difference(hand.skeleton, male.skeleton), 1e-6);
  ASSERT_EQ(hand.bind_mesh.triangles.size(), male.bind_mesh.triangles.size());
  for (const std::string_view name : kNamedPoses) {
    const Mesh posed = pose_skin(hand, named_pose(name)),
               expected = pose_skin(male, named_pose(name));
    for (std::size_t t = 0; t < posed.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3f& v = posed.vertices[posed.triangles[t][i]];
        ASSERT_LT((v - expected.vertices[expected.triangles[t][i]]).norm(), 2e-6) << name;
      }
    }
  }
}

// A .fbx repeats every vertex for each of its triangles: without welding there would be 30,000.
TEST_P(Formats, GiveEveryVertexOnce) {
  const TemporaryDirectory directory;
  const auto path = directory / ("male" + GetParam().extension);
  export_male(GetParam().id, path);
  EXPECT_EQ(load_hand(path, rig_map_beside(kMale)).bind_mesh.vertices.size(),
            load_hand(kMale).bind_mesh.vertices.size());
}

// assimp 5.2 cannot read its own binary .fbx.
INSTANTIATE_TEST_SUITE_P(Assimp, Formats,
                         ::testing::Values(Format{"collada", ".dae"}, Format{"fbxa", ".fbx"},
                                           Format{"glb2", ".glb"}),
                         [](const auto& format) { return format.param.id; });

}  // namespace
}  // namespace graspdb
