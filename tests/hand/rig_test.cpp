// SPDX-License-Identifier: MIT
#include "graspdb/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig_maps.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::kMale;
using testing::map_with;
using testing::refusal_with;
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

}  // namespace
}  // namespace graspdb
