// SPDX-License-Identifier: MIT
#include "graspdb/hand/rig/rig.h"

#include <fmt/format.h>

#include "forearm.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/hand/witness/palm_side.h"
#include "rebind.h"
#include "rest_frames.h"
#include "rig_fault.h"
#include "rig_file.h"
#include "rig_joints.h"
#include "rig_map.h"
#include "rig_skin.h"
#include "subdivide.h"

namespace graspdb {
namespace {

// Knuckles and the joints beyond them lie in a row, whatever a hand does at rest.
void check_order(const RestFrames& frames, const RigMap& map, const RigFile& file) {
  for (const FingerBone part : {kProximal, kMiddle, kDistal}) {
    for (int finger = 0; finger + 1 < kFingerCount; ++finger) {
      const Bone bone = finger_bone(finger, part), next = finger_bone(finger + 1, part);
      if (frames.hand_from_bone[bone].translation.x() < frames.hand_from_bone[next].translation.x())
        continue;
      fail(map, file, bone_key(next),
           fmt::format("a joint on the ulnar side of {}", bone_key(bone)),
           "one on its thumb's side");
    }
  }
}

void check(const RestFrames& frames, const RigMap& map, const RigFile& file) {
  check_order(frames, map, file);
  if (!(frames.skeleton.hand_from_bone_at_zero[kThumbMetacarpal].translation.x() < 0)) {
    fail(map, file, "bones.index_proximal", "the index on the thumb's side",
         "the little finger there");
  }
}

// In a mirrored hand what is taken for the palm is its back: thumb and fingers would bend away.
void check_handedness(const Hand& hand, const RigMap& map, const RigFile& file) {
  using enum PalmWitness::Verdict;
  const std::vector<PalmWitness> witnesses = palm_witnesses(hand);
  if (count_of(witnesses, kContradicts) == 0 ||
      count_of(witnesses, kAgrees) > count_of(witnesses, kContradicts))
    return;
  const char* const stated = map.is_left ? "a left" : "a right";
  const char* const other = map.is_left ? "a right" : "a left";
  std::string signs = fmt::format("signs of {} one ({})", other, seen_by(witnesses, kContradicts));
  if (count_of(witnesses, kAgrees) > 0) {
    signs += fmt::format(" and of {} one ({})", stated, seen_by(witnesses, kAgrees));
  }
  fail(map, file, "handedness", fmt::format("{} hand", stated), signs);
}

RigSkin skin_with_forearm(const RigMap& map, const RigFile& file, const RestFrames& frames) {
  RigSkin skin = skin_in_hand(map, file, frames.hand_from_file);
  const Eigen::Vector3d elbow = -frames.hand_from_bone[kForearm].rotation.col(1);
  if (map.forearm_extension > 0) {
    if (const auto fault = open_end(elbow, skin)) {
      fail(map, file, "forearm.extend_mm", "an end that is one cap or one open loop", *fault);
    }
  }
  if (map.longest_edge) subdivide(*map.longest_edge, skin);
  if (map.forearm_extension > 0) extend_forearm(map.forearm_extension, elbow, skin);
  if (map.forearm_split) split_forearm(*map.forearm_split, elbow, skin);
  return skin;
}

}  // namespace

std::filesystem::path rig_map_beside(const std::filesystem::path& hand_file) {
  std::filesystem::path path = hand_file;
  return path.replace_extension(".rig.toml");
}

Hand load_hand(const std::filesystem::path& hand_file, const std::filesystem::path& rig_map) {
  const RigFile file = read_rig_file(hand_file);
  const RigMap map = load_rig_map(rig_map);
  const RestFrames frames = frames_from_joints(rest_joints(map, file));
  check(frames, map, file);
  RigSkin skin = skin_with_forearm(map, file, frames);
  Hand hand{.name = hand_file.stem().string(),
            .origin = map.origin,
            .license = map.license,
            .skeleton = frames.skeleton,
            .bind_mesh = std::move(skin.mesh),
            .weights = four_largest(skin.weights),
            .hand_from_bone_at_bind = frames.hand_from_bone};
  check_handedness(hand, map, file);
  return map.bind_half_bent ? bound_half_bent(std::move(hand)) : hand;
}

Hand load_hand(const std::filesystem::path& hand_file) {
  return load_hand(hand_file, rig_map_beside(hand_file));
}

std::filesystem::path default_hand_file(const std::string& name) {
  return data_directory() / "assets/hands" / (name + ".glb");
}

}  // namespace graspdb
