// SPDX-License-Identifier: MIT
// What a rig map may leave to rules, and every way of getting that wrong.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/hand/named_poses.h"
#include "rig_file.h"
#include "rig_maps.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::kMale;
using testing::load_with;
using testing::map_with;
using testing::refusal_of;
using testing::refusal_with;
using testing::replaced;

const std::string kTip = "index = \"index_tip\"";

std::string map_plus(const std::string& text) {
  return read_text(rig_map_beside(kMale)) + text;
}

// As rigs have it whose palm is one bone.
std::string map_without_metacarpals() {
  std::string map = map_with("palm = [\"palm\"]", "palm = [\"palm\", \"M\"]"), names;
  for (const std::string finger : {"index", "middle", "ring", "little"}) {
    const std::string bone = finger + "_metacarpal";
    map = replaced(map, bone + " = [\"" + bone + "\"]\n", "");
    names += (names.empty() ? "\"" : ", \"") + bone + "\"";
  }
  return replaced(map, "\"M\"", names);
}

std::string map_without_forearm(const std::string& rule) {
  return replaced(map_with("palm = [\"palm\"]", "palm = [\"palm\", \"forearm\"]"),
                  "forearm = [\"forearm\"]\n", "") +
         rule;
}

TEST(RigMap, AbsentMetacarpalsLieBetweenWristAndKnuckleAndTheirSkinStaysWithThePalm) {
  const Hand whole = load_hand(kMale), hand = load_with(map_without_metacarpals());
  for (const std::string_view pose : {"flat", "wrap", "pinch"}) {
    EXPECT_LT((keypoints_in_hand(hand.skeleton, named_pose(pose)) -
               keypoints_in_hand(whole.skeleton, named_pose(pose)))
                  .cwiseAbs()
                  .maxCoeff(),
              .001)
        << pose;
  }
  const Bone metacarpal = finger_bone(3, kMetacarpal);
  const auto& zero = hand.skeleton.hand_from_bone_at_zero;
  EXPECT_NEAR(
      (zero[metacarpal].translation - .3 * zero[finger_bone(3, kProximal)].translation).norm(), 0,
      1e-9);
  for (std::size_t v = 0; v < hand.weights.size(); ++v) {
    EXPECT_EQ(testing::weight_of_bones(hand.weights[v])[metacarpal], 0);
  }
}

TEST(RigMap, TipsMayBePointsOrLengths) {
  const Hand whole = load_hand(kMale);
  const auto tip_with = [&](const std::string& text) {
    return load_with(map_with(kTip, text)).skeleton.tip_in_distal[1];
  };
  EXPECT_NEAR(tip_with("index_beyond_distal_mm = 17").y(), .017, 1e-12);
  const Eigen::Vector3d tip = read_rig_file(kMale).joints.at("index_tip");
  EXPECT_LT((tip_with(fmt::format("index_position = [{}, {}, {}]", tip.x(), tip.y(), tip.z())) -
             whole.skeleton.tip_in_distal[1])
                .norm(),
            1e-9);
}

TEST(RigMap, TipsThatItDoesNotNameLieOnTheSkin) {
  std::string map = read_text(rig_map_beside(kMale));
  map.resize(map.find("[tips]"));
  const Hand whole = load_hand(kMale), hand = load_with(map);
  for (const std::string_view pose : kNamedPoses) {
    EXPECT_LT((keypoints_in_hand(hand.skeleton, named_pose(pose)) -
               keypoints_in_hand(whole.skeleton, named_pose(pose)))
                  .colwise()
                  .norm()
                  .maxCoeff(),
              .001)
        << pose;
  }
}

TEST(RigMap, RefusesTipsGivenTwiceOrWrongly) {
  EXPECT_THAT(refusal_with(kTip, kTip + "\nindex_beyond_distal_mm = 20"),
              AllOf(HasSubstr("tips.index"), HasSubstr("2 of them")));
  EXPECT_THAT(refusal_with(kTip, "index = \"ring_tip\""),
              AllOf(HasSubstr("tips.ring"), HasSubstr("twice")));
  EXPECT_THAT(refusal_with(kTip, "index = \"index_distal\""),
              AllOf(HasSubstr("tips.index"), HasSubstr("twice")));
  EXPECT_THAT(refusal_with(kTip, "index = \"nail\""),
              AllOf(HasSubstr("tips.index"), HasSubstr("\"nail\""), HasSubstr("index_tip")));
  EXPECT_THAT(refusal_with(kTip, "index_beyond_distal_mm = 200"),
              HasSubstr("tips.index_beyond_distal_mm"));
  EXPECT_THAT(refusal_with(kTip, "index_position = [1, 2]"), HasSubstr("tips.index_position"));
  EXPECT_THAT(refusal_with(kTip, "forefinger = \"index_tip\""), HasSubstr("tips.forefinger"));
}

TEST(RigMap, AForearmIsSplitOffAsSmoothlyAsTheMakerDoes) {
  // The maker's own rule for a hand of this breadth: half at 4.5, all of it within 75 mm.
  const Hand whole = load_hand(kMale);
  const Hand split =
      load_with(map_without_forearm("[forearm]\nsplit_at_mm = 4.6\nsplit_width_mm = 77\n"));
  double largest = 0;
  for (std::size_t v = 0; v < whole.weights.size(); ++v) {
    const float before = testing::weight_of_bones(whole.weights[v])[kForearm];
    const float after = testing::weight_of_bones(split.weights[v])[kForearm];
    largest = std::max<double>(largest, std::abs(before - after));
  }
  EXPECT_LT(largest, .1);
  EXPECT_LT(testing::largest_difference(split.bind_mesh, whole.bind_mesh), 1e-6);
}

TEST(RigMap, RefusesAForearmWithoutARuleOrWithTwo) {
  EXPECT_THAT(refusal_of(map_without_forearm("")), HasSubstr("forearm"));
  EXPECT_THAT(refusal_of(map_without_forearm("[forearm]\n")), HasSubstr("forearm.split_at_mm"));
  EXPECT_THAT(refusal_of(map_without_forearm("[forearm]\nsplit_at_mm = 4\n")),
              HasSubstr("forearm.split_width_mm"));
  EXPECT_THAT(refusal_of(map_without_forearm("[forearm]\nsplit_at_mm = 4\nsplit_width_mm = 0\n")),
              HasSubstr("forearm.split_width_mm"));
  EXPECT_THAT(refusal_of(map_without_forearm("[forearm]\nsplit_at = 4\nsplit_width_mm = 40\n")),
              HasSubstr("forearm.split_at_mm"));
  EXPECT_THAT(refusal_of(map_plus("[forearm]\nsplit_at_mm = 4\nsplit_width_mm = 40\n")),
              AllOf(HasSubstr("forearm.split_at_mm"), HasSubstr("bones.forearm")));
  EXPECT_THAT(refusal_of(map_plus("[forearm]\nextend_mm = -1\n")), HasSubstr("forearm.extend_mm"));
  EXPECT_THAT(refusal_of(map_plus("[forearm]\nextend_cm = 1\n")), HasSubstr("forearm.extend_cm"));
}

TEST(RigMap, CorrectionsMoveJointsAlongTheirBonesAndRollFingers) {
  const Hand whole = load_hand(kMale);
  const Hand moved = load_with(map_plus("[corrections]\nindex_middle_mm = -6\n"));
  const Bone proximal = finger_bone(0, kProximal), middle = finger_bone(0, kMiddle);
  const auto length = [](const Hand& hand, Bone bone, Bone next) {
    return (hand.hand_from_bone_at_bind[next].translation -
            hand.hand_from_bone_at_bind[bone].translation)
        .norm();
  };
  EXPECT_NEAR(length(moved, middle, finger_bone(0, kDistal)),
              length(whole, middle, finger_bone(0, kDistal)) + .006, 1e-9);
  EXPECT_LT(length(moved, proximal, middle), length(whole, proximal, middle));

  const Hand rolled = load_with(map_plus("[corrections]\nring_roll_deg = 20\n"));
  const Bone ring = finger_bone(2, kProximal);
  EXPECT_NEAR(angle_between(rolled.hand_from_bone_at_bind[ring].rotation,
                            whole.hand_from_bone_at_bind[ring].rotation),
              radians(20), 1e-9);
  // Its back turns to the thumb's side, against x.
  EXPECT_LT(rolled.hand_from_bone_at_bind[ring].rotation.col(2).x(),
            whole.hand_from_bone_at_bind[ring].rotation.col(2).x());
  EXPECT_LT(testing::largest_difference(rolled.skeleton, whole.skeleton), 1e-12);
}

TEST(RigMap, RefusesSkinThatItCannotMake) {
  for (const std::string line : {"longest_edge_mm = 0", "longest_edge_mm = \"short\"",
                                 "longest_edge = 10", "bind_half_bent = 1", "bound = true"}) {
    EXPECT_THAT(refusal_of(map_plus("[skin]\n" + line + "\n")),
                HasSubstr("skin." + line.substr(0, line.find(' '))));
  }
}

TEST(RigMap, RefusesCorrectionsOfWhatIsNotThere) {
  EXPECT_THAT(refusal_of(map_without_metacarpals() + "[corrections]\nring_metacarpal_mm = 2\n"),
              AllOf(HasSubstr("corrections.ring_metacarpal_mm"), HasSubstr("no bones.ring_meta")));
  for (const std::string key : {"forearm_mm", "thumb_roll_deg", "index_proximal", "sixth_mm"}) {
    EXPECT_THAT(refusal_of(map_plus("[corrections]\n" + key + " = 2\n")),
                HasSubstr("corrections." + key));
  }
  EXPECT_THAT(refusal_of(map_plus("[corrections]\nindex_proximal_mm = 90\n")),
              HasSubstr("corrections.index_proximal_mm"));
  EXPECT_THAT(refusal_of(map_plus("[corrections]\nindex_roll_deg = \"much\"\n")),
              HasSubstr("corrections.index_roll_deg"));
  EXPECT_THAT(refusal_of(map_plus("[corrections]\nindex_middle_mm = 32\n")),
              HasSubstr("bones.index_distal"));  // moved beyond the next joint
}

TEST(RigMap, RefusesBonesThatMayNotBeAbsentAndNamesTheFilesJoints) {
  EXPECT_THAT(refusal_with("palm = [\"palm\"]\n", ""), HasSubstr("bones.palm"));
  EXPECT_THAT(refusal_with("thumb_metacarpal = [\"thumb_metacarpal\"]\n", ""),
              HasSubstr("bones.thumb_metacarpal"));
  EXPECT_THAT(refusal_with("[\"index_metacarpal\"]", "[]"), HasSubstr("bones.index_metacarpal"));
  EXPECT_THAT(refusal_with("[\"index_middle\"]", "\"index_middle\""),
              HasSubstr("bones.index_middle"));
  EXPECT_THAT(refusal_with("[\"index_middle\"]", "[\"index2\"]"),
              AllOf(HasSubstr("bones.index_middle"), HasSubstr("index_distal, index_metacarpal"),
                    HasSubstr("male.glb")));
  EXPECT_THAT(refusal_with("[tips]", "[toes]"), HasSubstr("toes"));
}

}  // namespace
}  // namespace graspdb
