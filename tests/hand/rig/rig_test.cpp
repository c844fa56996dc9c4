// SPDX-License-Identifier: MIT
#include "graspdb/hand/rig/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "rig_maps.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::kMale;
using testing::map_with;
using testing::refusal_with;
using testing::replaced;
using testing::TemporaryDirectory;

TEST(Rig, MapLiesBesideTheHand) {
  EXPECT_EQ(rig_map_beside("a/b.glb"), std::filesystem::path("a/b.rig.toml"));
}

TEST(Rig, NamesTheBoneThatTheFileDoesNotHave) {
  const std::string said = refusal_with("ring_middle = [\"ring_middle\"]", "ring_middle = [\"x\"]");
  EXPECT_THAT(said, HasSubstr("bones.ring_middle"));
  EXPECT_THAT(said, HasSubstr("\"x\""));
  EXPECT_THAT(said, HasSubstr("male.glb"));
  EXPECT_THAT(said, HasSubstr("map.toml"));
}

TEST(Rig, NamesTheBoneThatTheMapForgets) {
  EXPECT_THAT(refusal_with("little_distal = [\"little_distal\"]\n", ""),
              HasSubstr("bones.little_distal"));
}

TEST(Rig, RefusesSkinOnABoneThatIsNotMapped) {
  EXPECT_THAT(refusal_with("index_metacarpal = [\"index_metacarpal\"]\n", ""),
              AllOf(HasSubstr("\"index_metacarpal\""), HasSubstr("male.glb")));
}

TEST(Rig, RefusesABoneThatIsMappedTwice) {
  EXPECT_THAT(refusal_with("[\"ring_middle\"]", "[\"ring_distal\"]"), HasSubstr("twice"));
}

TEST(Rig, SeveralBonesMayMoveOne) {
  const std::string map =
      testing::replaced(map_with("[\"little_middle\"]", "[\"little_middle\", \"little_distal\"]"),
                        "[\"little_distal\"]", "[\"little_tip\"]");
  const Hand whole = load_hand(kMale);
  const Hand joined = testing::load_with(
      testing::replaced(map, "little = \"little_tip\"", "little_beyond_distal_mm = 10"));
  const int middle = finger_bone(3, kMiddle), distal_bone = finger_bone(3, kDistal);
  for (std::size_t v = 0; v < whole.weights.size(); ++v) {
    const auto before = testing::weight_of_bones(whole.weights[v]);
    const auto after = testing::weight_of_bones(joined.weights[v]);
    ASSERT_NEAR(after[middle], before[middle] + before[distal_bone], 1e-6);
    ASSERT_EQ(after[distal_bone], 0);
  }
}

TEST(Rig, RefusesTheWrongHandedness) {
  EXPECT_THAT(refusal_with("\"right\"", "\"left\""), HasSubstr("handedness"));
  EXPECT_THAT(refusal_with("\"right\"", "\"both\""), HasSubstr("handedness"));
}

std::string with_swapped(std::string map, const std::string& a, const std::string& b) {
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = map.find("\"" + from, at)) != std::string::npos;) {
      map.replace(at, from.size() + 1, "\"" + to);
    }
  };
  rename(a, "swapped");
  rename(b, a);
  rename("swapped", b);
  return map;
}

TEST(Rig, RefusesFingersAndJointsInTheWrongOrder) {
  const std::string map = read_text(rig_map_beside(kMale));
  const auto refusal = [&](const std::string& a, const std::string& b) {
    return testing::refusal_of(with_swapped(map, a, b));
  };
  EXPECT_THAT(refusal("index_", "little_"), HasSubstr("bones."));
  EXPECT_THAT(refusal("middle_", "ring_"), HasSubstr("bones.ring_proximal"));
  EXPECT_THAT(refusal("ring_middle", "little_middle"), HasSubstr("bones.little_middle"));
  EXPECT_THAT(refusal("ring_middle", "ring_distal"), HasSubstr("bones.ring_distal"));
  EXPECT_THAT(refusal("thumb_proximal", "thumb_distal"), HasSubstr("bones.thumb_"));
}

TEST(Rig, RefusesAHandOfTheWrongSize) {
  EXPECT_THAT(refusal_with("handedness", "metres_per_unit = 0.01\nhandedness"),
              HasSubstr("metres_per_unit"));
}

TEST(Rig, RefusesUnknownKeysAndANailWithoutDirection) {
  EXPECT_THAT(refusal_with("handedness", "handiness = 1\nhandedness"), HasSubstr("handiness"));
  EXPECT_THAT(refusal_with("thumb_nail = [", "thumb_nail = [0, 0, 0] #"), HasSubstr("thumb_nail"));
}

TEST(Rig, NamesTheFileThatIsNotThere) {
  try {
    load_hand("nowhere.glb", rig_map_beside(kMale));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("nowhere.glb"));
  }
}

TEST(Rig, RefusesATruncatedFile) {
  const TemporaryDirectory directory;
  const std::string whole = read_text(kMale);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{10}, std::size_t{500}, whole.size() / 2, whole.size() - 1}) {
    write_text(directory / "cut.glb", whole.substr(0, length));
    EXPECT_THROW(load_hand(directory / "cut.glb", rig_map_beside(kMale)), Error) << length;
  }
}

// The male hand with numbers written over those at the start of one vertex' data; a .glb keeps the
// positions of all vertices, then their normals.
std::string refusal_of_file(std::size_t byte_of_data, const std::string& bytes) {
  const TemporaryDirectory directory;
  std::string file = read_text(kMale);
  const std::size_t data = file.find(std::string("BIN\0", 4)) + 4;
  write_text(directory / "spoilt.glb", file.replace(data + byte_of_data, bytes.size(), bytes));
  try {
    load_hand(directory / "spoilt.glb", rig_map_beside(kMale));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::string bytes_of(float number) {
  return std::string(reinterpret_cast<const char*>(&number), sizeof number);
}

TEST(Rig, RefusesSkinThatLiesNowhereOrTooFarAway) {
  constexpr std::size_t kVertex = 100 * 12;
  const std::size_t normals = load_hand(kMale).bind_mesh.vertices.size() * 12;
  const float nan = std::nanf("");
  for (const float number : {nan, 1e30F}) {
    EXPECT_THAT(refusal_of_file(kVertex, bytes_of(number)), HasSubstr("element 100"));
    EXPECT_THAT(refusal_of_file(normals + kVertex, bytes_of(number)), HasSubstr("element 100"));
  }
  for (const float far : {2.F, -50.F, 1e6F}) {
    EXPECT_THAT(refusal_of_file(kVertex, bytes_of(far)), HasSubstr("of the wrist")) << far;
  }
}

TEST(Rig, RefusesAMeshOfLines) {
  const TemporaryDirectory directory;
  // As long as before: the file says how long its parts are.
  const std::string lines = replaced(replaced(read_text(kMale), "\"NORMAL\":1,", "  "),
                                     "\"indices\":5", "\"indices\":5,\"mode\":1");
  write_text(directory / "lines.glb", lines);
  EXPECT_THROW(load_hand(directory / "lines.glb", rig_map_beside(kMale)), Error);
}

}  // namespace
}  // namespace graspdb
