// SPDX-License-Identifier: MIT
// The lines that are read from the file: of the male hand, and of it spoilt and written by assimp.
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <functional>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/hand/check/hand_file_check.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;
using Status = HandCheckLine::Status;

const std::filesystem::path kMale = GRASPDB_SOURCE_DIR "/assets/hands/male.glb";

using Spoil = std::function<void(aiMesh&)>;

// The male hand's file checked after something was done to its mesh.
std::vector<HandCheckLine> checked(const Spoil& spoil, const std::string& format = "collada",
                                   const std::string& extension = ".dae") {
  const TemporaryDirectory directory;
  const auto path = directory / ("hand" + extension);
  Assimp::Importer importer;
  importer.ReadFile(kMale.string(), 0);
  const std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
  spoil(*scene->mMeshes[0]);
  Assimp::Exporter exporter;
  EXPECT_EQ(exporter.Export(scene.get(), format, path.string()), aiReturn_SUCCESS);
  return check_hand_file(path);
}

// The other lines must not mind.
void expect_only_failure(const std::vector<HandCheckLine>& lines, const std::string& name,
                         const std::string& why) {
  for (const HandCheckLine& line : lines) {
    EXPECT_EQ(status_name(line.status), line.name == name ? "fail" : "pass")
        << line.name << " " << line.value << " " << line.why;
    if (line.name != name) continue;
    EXPECT_THAT(line.why, HasSubstr(why));
  }
}

aiBone& bone_named(aiMesh& mesh, const std::string& name) {
  for (unsigned b = 0; b < mesh.mNumBones; ++b) {
    if (name == mesh.mBones[b]->mName.C_Str()) return *mesh.mBones[b];
  }
  throw std::out_of_range(name);
}

TEST(HandFileCheck, PassesOnAGoodHandInEveryFormat) {
  for (const auto& lines :
       {check_hand_file(kMale), checked([](aiMesh&) {}), checked([](aiMesh&) {}, "fbxa", ".fbx"),
        checked([](aiMesh&) {}, "glb2", ".glb")}) {
    ASSERT_EQ(lines.size(), 4);
    expect_only_failure(lines, "none", "");
  }
}

TEST(HandFileCheck, AWeightTooLargeIsFoundAtItsVertex) {
  const auto lines = checked([](aiMesh& mesh) {
    aiVertexWeight& weight = bone_named(mesh, "index_distal").mWeights[0];
    weight.mWeight += .001f;
  });
  expect_only_failure(lines, "weight sum", "vertex");
  EXPECT_NEAR(lines[0].value, .001, 1e-6);
}

TEST(HandFileCheck, ANegativeWeightIsFoundThoughTheSumIsRight) {
  // assimp's reader of .dae drops what is not positive.
  const Spoil spoil = [](aiMesh& mesh) {
    aiBone& palm = bone_named(mesh, "palm");
    aiBone& forearm = bone_named(mesh, "forearm");
    for (unsigned i = 0; i < palm.mNumWeights; ++i) {
      for (unsigned j = 0; j < forearm.mNumWeights; ++j) {
        if (palm.mWeights[i].mVertexId != forearm.mWeights[j].mVertexId) continue;
        palm.mWeights[i].mWeight += forearm.mWeights[j].mWeight + .1f;
        forearm.mWeights[j].mWeight = -.1f;
        return;
      }
    }
  };
  const auto lines = checked(spoil, "fbxa", ".fbx");
  expect_only_failure(lines, "least weight", "forearm");
  EXPECT_NEAR(lines[1].value, -.1, 1e-6);
}

TEST(HandFileCheck, AFifthBoneIsFound) {
  const auto lines = checked([](aiMesh& mesh) {
    // Each of the five takes a fifth of vertex 0.
    const char* const names[] = {"palm", "ring_middle", "ring_distal", "index_middle", "forearm"};
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      aiBone& bone = *mesh.mBones[b];
      std::vector<aiVertexWeight> kept;
      for (unsigned i = 0; i < bone.mNumWeights; ++i) {
        if (bone.mWeights[i].mVertexId != 0) kept.push_back(bone.mWeights[i]);
      }
      const bool shares = std::find(std::begin(names), std::end(names),
                                    std::string(bone.mName.C_Str())) != std::end(names);
      if (shares) kept.push_back({0, .2f});
      delete[] bone.mWeights;
      bone.mNumWeights = static_cast<unsigned>(kept.size());
      bone.mWeights = new aiVertexWeight[kept.size()];
      std::copy(kept.begin(), kept.end(), bone.mWeights);
    }
  });
  expect_only_failure(lines, "bones a vertex", "vertex");
  EXPECT_EQ(lines[2].value, 5);
}

TEST(HandFileCheck, ABoneThatWasMovedSinceItWasBoundIsNamed) {
  const auto lines =
      checked([](aiMesh& mesh) { bone_named(mesh, "ring_middle").mOffsetMatrix.a4 += .0001f; });
  expect_only_failure(lines, "bind identity", "ring_middle");
}

TEST(HandFileCheck, SaysWhoWroteTheFile) {
  EXPECT_EQ(hand_file_generator(kMale), "graspdb");
}

TEST(HandFileCheck, RefusesWhatIsNoRiggedHand) {
  const TemporaryDirectory directory;
  write_text(directory / "triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(directory / "text.glb", "no such thing");
  for (const char* name : {"triangle.obj", "text.glb", "absent.glb"}) {
    try {
      check_hand_file(directory / name);
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace graspdb
