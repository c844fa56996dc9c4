// SPDX-License-Identifier: MIT
#include "graspdb/rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/error.h"
#include "graspdb/file.h"
#include "support/compare_hands.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

const std::filesystem::path kMale = GRASPDB_SOURCE_DIR "/assets/hands/male.glb";

// The male hand's rig map with one piece of text in place of another.
std::string map_with(const std::string& old_text, const std::string& new_text) {
  std::string map = read_text(rig_map_beside(kMale));
  const auto place = map.find(old_text);
  EXPECT_NE(place, std::string::npos) << old_text;
  return map.replace(place, old_text.size(), new_text);
}

// What loading says to that map.
std::string refusal_with(const std::string& old_text, const std::string& new_text) {
  const TemporaryDirectory directory;
  write_text(directory / "map.toml", map_with(old_text, new_text));
  try {
    load_hand(kMale, directory / "map.toml");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

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
  // The index's distal bone is looked for in its tip; the skin of the real one has no owner.
  EXPECT_THAT(refusal_with("[\"index_distal\"]", "[\"index_tip\"]"), HasSubstr("index_distal"));
}

TEST(Rig, RefusesABoneThatIsMappedTwice) {
  EXPECT_THAT(refusal_with("[\"ring_middle\"]", "[\"ring_distal\"]"), HasSubstr("twice"));
}

TEST(Rig, SeveralBonesMayMoveOne) {
  const TemporaryDirectory directory;
  std::string map = map_with("[\"little_middle\"]", "[\"little_middle\", \"little_distal\"]");
  const std::string distal = "little_distal = [\"little_distal\"]", tip = "\"little_tip\"";
  map.replace(map.find(distal), distal.size(), "little_distal = [\"little_tip\"]");
  map.replace(map.find(tip), tip.size(), "\"ring_tip\"");
  write_text(directory / "map.toml", map);
  const Hand whole = load_hand(kMale), joined = load_hand(kMale, directory / "map.toml");
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

TEST(Rig, RefusesFingersInTheWrongOrder) {
  const TemporaryDirectory directory;
  std::string map = read_text(rig_map_beside(kMale));
  const auto swap_names = [&](const std::string& a, const std::string& b) {
    for (std::size_t at = 0; (at = map.find("\"" + a, at)) != std::string::npos;) {
      map.replace(at, a.size() + 1, "\"" + b);
    }
  };
  swap_names("index_", "swapped_");
  swap_names("little_", "index_");
  swap_names("swapped_", "little_");
  write_text(directory / "map.toml", map);
  EXPECT_THROW(load_hand(kMale, directory / "map.toml"), Error);
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
