// SPDX-License-Identifier: MIT
// The male hand, what can be done to it, and what the check then says.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "graspdb/core/random.h"
#include "graspdb/hand/check/hand_check.h"
#include "graspdb/hand/rig/rig.h"

namespace graspdb::testing {

using Lines = std::vector<HandCheckLine>;
using Status = HandCheckLine::Status;

inline const Hand& male() {
  static const Hand hand = load_hand(GRASPDB_SOURCE_DIR "/assets/hands/male.glb");
  return hand;
}

inline HandCheckLine line_of(const Lines& lines, const std::string& name) {
  for (const HandCheckLine& line : lines) {
    if (line.name == name) return line;
  }
  ADD_FAILURE() << "no line " << name;
  return {};
}

inline void expect_pass(const Lines& lines, const std::string& name) {
  const HandCheckLine line = line_of(lines, name);
  EXPECT_EQ(status_name(line.status), "pass") << name << " " << line.value << " " << line.why;
}

inline void expect_fail(const Lines& lines, const std::string& name, const std::string& why = "") {
  const HandCheckLine line = line_of(lines, name);
  EXPECT_EQ(status_name(line.status), "fail") << name << " " << line.value << " " << line.why;
  EXPECT_THAT(line.why, ::testing::HasSubstr(why)) << name;
}

inline void expect_not_applicable(const Lines& lines, const std::string& name,
                                  const std::string& why) {
  const HandCheckLine line = line_of(lines, name);
  EXPECT_EQ(status_name(line.status), "not applicable") << name << " " << line.value;
  EXPECT_THAT(line.why, ::testing::HasSubstr(why)) << name;
}

// All skin of one bone is given to another.
inline Hand with_skin_of_given_to(int from, int to) {
  Hand hand = male();
  for (SkinWeights& skin : hand.weights) {
    for (std::uint8_t& bone : skin.bone) {
      if (bone == from) bone = static_cast<std::uint8_t>(to);
    }
  }
  return hand;
}

inline SkinWeights only(int bone) {
  return {{static_cast<std::uint8_t>(bone)}, {1}};
}

// One in five vertices of a bone, by chance, follows `other` alone.
inline Hand with_tattered_skin(int bone, int other) {
  Hand hand = male();
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  RandomStream random(5);
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (bones[v] == bone && random.uniform() < .2) hand.weights[v] = only(other);
  }
  return hand;
}

// The frames of some bones turned about their own length, at zero and at bind: the hand looks the
// same, and its joints bend another way.
inline Hand with_bones_rolled(int first, int last, double angle) {
  Hand hand = male();
  for (int bone = first; bone <= last; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    for (RigidTransform* frame :
         {&hand.skeleton.hand_from_bone_at_zero[b], &hand.hand_from_bone_at_bind[b]}) {
      frame->rotation = frame->rotation * axis_rotation(1, angle);
    }
  }
  return hand;
}

// The skeleton's bones from `first` to `last` moved at zero, the skin's not.
inline Hand with_bones_moved(int first, int last, const Eigen::Vector3d& by) {
  Hand hand = male();
  for (int bone = first; bone <= last; ++bone) {
    hand.skeleton.hand_from_bone_at_zero[static_cast<std::size_t>(bone)].translation += by;
  }
  return hand;
}

// As if its skin had been made and bound flat.
inline Hand bound_flat() {
  Hand hand = male();
  hand.hand_from_bone_at_bind = hand_from_bones(hand.skeleton, JointAngles::Zero());
  hand.bind_mesh = pose_skin(male(), JointAngles::Zero());
  return hand;
}

inline Hand scaled(double factor) {
  Hand hand = male();
  for (Eigen::Vector3f& v : hand.bind_mesh.vertices) v *= static_cast<float>(factor);
  for (std::size_t b = 0; b < kBoneCount; ++b) {
    hand.skeleton.hand_from_bone_at_zero[b].translation *= factor;
    hand.hand_from_bone_at_bind[b].translation *= factor;
  }
  for (Eigen::Vector3d& tip : hand.skeleton.tip_in_distal) tip *= factor;
  return hand;
}

}  // namespace graspdb::testing
