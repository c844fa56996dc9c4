// SPDX-License-Identifier: MIT
#include "angles.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bitset>
#include <cmath>

#include "graspdb/geometry/triangle.h"
#include "lines.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;
using BoneSet = std::bitset<kBoneCount>;

// The bone right beyond the joint that an angle turns.
int first_moved_bone(int angle) {
  if (angle < kThumbCmcFlexion) return kForearm;
  if (angle < kThumbMcpFlexion) return kThumbMetacarpal;
  if (angle < kThumbIpFlexion) return kThumbProximal;
  if (angle < kFirstFingerAngle) return kThumbDistal;
  constexpr FingerBone kMoved[] = {kMetacarpal, kProximal, kProximal, kMiddle, kDistal};
  const int finger = (angle - kFirstFingerAngle) / 5;
  return finger_bone(finger, kMoved[(angle - kFirstFingerAngle) % 5]);
}

BoneSet moved_bones(int angle) {
  BoneSet moved;
  moved.set(static_cast<std::size_t>(first_moved_bone(angle)));
  for (int bone = kForearm; bone < kBoneCount; ++bone) {
    if (moved.test(static_cast<std::size_t>(bone_parent(bone)))) {
      moved.set(static_cast<std::size_t>(bone));
    }
  }
  return moved;
}

struct Segment {
  Vector3d from, to;
};

Vector3d far_end(const Hand& hand, int bone) {
  const PerBone<RigidTransform>& frames = hand.hand_from_bone_at_bind;
  const auto b = static_cast<std::size_t>(bone);
  if (bone == kForearm) return frames[b] * Vector3d(0, -.25, 0);
  if (bone == kPalm) {
    Vector3d sum = Vector3d::Zero();
    for (int f = 0; f < kFingerCount; ++f) sum += frames[finger_bone(f, kMetacarpal)].translation;
    return sum / kFingerCount;
  }
  for (int digit = 0; digit < kDigitCount; ++digit) {
    if (bone == distal_bone(digit)) {
      return frames[b] * hand.skeleton.tip_in_distal[static_cast<std::size_t>(digit)];
    }
  }
  return frames[b + 1].translation;
}

// How far a point of the skin lies from every bone, in the bind pose.
PerBone<double> distances_to_bones(const PerBone<Segment>& bones, const Vector3d& point) {
  PerBone<double> distances;
  for (std::size_t b = 0; b < kBoneCount; ++b) {
    distances[b] = distance_to_segment(point, bones[b].from, bones[b].to);
  }
  return distances;
}

// By how much a vertex lies nearer to the bones that it does not follow; negative when it is right.
double wrongness(const SkinWeights& skin, const PerBone<double>& distances, const BoneSet& moved) {
  double share = 0, to_moved = 1, to_others = 1;
  for (std::size_t i = 0; i < 4; ++i) share += moved.test(skin.bone[i]) ? skin.weight[i] : 0;
  for (std::size_t b = 0; b < kBoneCount; ++b) {
    double& least = moved.test(b) ? to_moved : to_others;
    least = std::min(least, distances[b]);
  }
  return share > .5 ? to_moved - to_others : to_others - to_moved;
}

// The joints whose skin is judged together. The flesh of the palm is shared: between metacarpals
// and at the thumb's root it need not follow the nearest bone.
struct JointGroup {
  const char* name;
  bool (*contains)(int angle);
  double gate;  // percent of the hand's length
};

bool is_wrist(int angle) {
  return angle < kThumbCmcFlexion;
}
bool is_cmc(int angle) {
  return !is_wrist(angle) &&
         (angle < kThumbMcpFlexion ||
          (angle >= kFirstFingerAngle && (angle - kFirstFingerAngle) % 5 == kCmcFlexion));
}
bool is_in_digit(int angle) {
  return !is_wrist(angle) && !is_cmc(angle);
}
constexpr JointGroup kJoints[] = {
    {"wrist", is_wrist, 15}, {"CMC joints", is_cmc, 15}, {"digits", is_in_digit, 3}};

HandCheckLine worst_following(const Hand& hand, const std::vector<PerBone<double>>& distances,
                              const JointGroup& group) {
  Worst worst;
  Missing missing;
  for (int angle = 0; angle < kAngleCount; ++angle) {
    if (!group.contains(angle) || missing.lacks_skin(hand, first_moved_bone(angle))) continue;
    const BoneSet moved = moved_bones(angle);
    for (std::size_t v = 0; v < distances.size(); ++v) {
      worst.take(wrongness(hand.weights[v], distances[v], moved),
                 [&] { return fmt::format("{}, vertex {}", angle_info(angle).name, v); });
    }
  }
  worst.value *= 100 / hand_length(hand.skeleton);
  return judged_unless(missing, fmt::format("skin follows, {}", group.name), worst, "%",
                       at_most(group.gate));
}

void add_following_lines(const Hand& hand, std::vector<HandCheckLine>& lines) {
  PerBone<Segment> bones;
  for (std::size_t b = 0; b < kBoneCount; ++b) {
    bones[b] = {hand.hand_from_bone_at_bind[b].translation, far_end(hand, static_cast<int>(b))};
  }
  std::vector<PerBone<double>> distances;
  for (const Eigen::Vector3f& v : hand.bind_mesh.vertices) {
    distances.push_back(distances_to_bones(bones, v.cast<double>()));
  }
  for (const JointGroup& group : kJoints) lines.push_back(worst_following(hand, distances, group));
}

// The outermost bone that the angle moves and that moves skin.
std::optional<int> seen_bone(const Hand& hand, int angle) {
  const BoneSet moved = moved_bones(angle);
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  for (int bone = kBoneCount - 1; bone > 0; --bone) {
    if (moved.test(static_cast<std::size_t>(bone)) &&
        std::find(bones.begin(), bones.end(), bone) != bones.end()) {
      return bone;
    }
  }
  return std::nullopt;
}

Vector3d expected_direction(int angle) {
  Vector3d ulnar(1, 0, 0), dorsal(0, 0, 1);
  if (angle == kThumbCmcAxial) return dorsal;
  if (angle == kThumbCmcAbduction || angle == kThumbMcpAbduction) return -dorsal;
  if (angle >= kThumbCmcFlexion && angle < kFirstFingerAngle) return ulnar;
  const bool sideways =
      angle == kWristDeviation ||
      (angle >= kFirstFingerAngle && (angle - kFirstFingerAngle) % 5 == kMcpAbduction);
  return sideways ? -ulnar : Vector3d(-dorsal);
}

Vector3d without(const Vector3d& v, const Vector3d& direction) {
  const Vector3d unit = direction.normalized();
  return v - v.dot(unit) * unit;
}

double angle_between_directions(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Mean place, or mean normal on the palmar side, of the skin that most follows a bone.
Vector3d mean_place(const Hand& hand, const Mesh& posed, int bone) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  Vector3d sum = Vector3d::Zero();
  double count = 0;
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (bones[v] != bone) continue;
    sum += posed.vertices[v].cast<double>();
    ++count;
  }
  return sum / count;
}

Vector3d mean_palmar_normal(const Hand& hand, const Mesh& posed, int bone) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const Vector3d palmar =
      -hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)].rotation.col(2);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (bones[v] != bone || hand.bind_mesh.normals[v].cast<double>().dot(palmar) < .7) continue;
    sum += posed.normals[v].cast<double>();
  }
  return sum.normalized();
}

// Between the way in which the first degrees of an angle move the skin, and the way they should.
double direction_error(const Hand& hand, int angle, int seen) {
  JointAngles before = JointAngles::Zero();
  if (angle == kThumbCmcAxial) before[kThumbCmcAbduction] = radians(45);
  JointAngles after = before;
  after[angle] = std::min(radians(15), angle_info(angle).upper);
  const Mesh skin_before = pose_skin(hand, before), skin_after = pose_skin(hand, after);
  const Vector3d joint =
      hand_from_bones(hand.skeleton, before)[static_cast<std::size_t>(first_moved_bone(angle))]
          .translation;
  const Vector3d place = mean_place(hand, skin_before, seen), lever = place - joint;
  const Vector3d expected = without(expected_direction(angle), lever);
  if (angle == kThumbCmcAxial) {
    const Vector3d pulp = mean_palmar_normal(hand, skin_before, seen);
    const Vector3d turned = mean_palmar_normal(hand, skin_after, seen) - pulp;
    return angle_between_directions(without(turned, lever), without(expected, pulp));
  }
  const Vector3d moved = mean_place(hand, skin_after, seen) - place;
  return angle_between_directions(without(moved, lever), expected);
}

HandCheckLine worst_direction(const Hand& hand, const AngleGroup& group) {
  Worst worst;
  Missing missing;
  for (int angle = group.first; angle < group.end; ++angle) {
    const auto seen = seen_bone(hand, angle);
    if (!seen) {
      missing.lacks_skin(hand, first_moved_bone(angle));
      continue;
    }
    worst.take(degrees(direction_error(hand, angle, *seen)),
               [&] { return std::string(angle_info(angle).name); });
  }
  return judged_unless(missing, fmt::format("direction, {}", group.name), worst, "deg",
                       at_most(45));
}

}  // namespace

std::vector<HandCheckLine> check_angles(const Hand& hand) {
  std::vector<HandCheckLine> lines;
  add_following_lines(hand, lines);
  for (const AngleGroup& group : kAngleGroups) lines.push_back(worst_direction(hand, group));
  return lines;
}

}  // namespace graspdb
