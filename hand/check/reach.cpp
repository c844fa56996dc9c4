// SPDX-License-Identifier: MIT
#include "reach.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "graspdb/geometry/triangle.h"
#include "graspdb/hand/named_poses.h"
#include "lines.h"
#include "meeting.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

// The triangles of a digit's distal bone alone, in some pose.
std::vector<Corners> distal_skin(const Hand& hand, const Mesh& posed, int digit) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::vector<Corners> skin;
  for (const Triangle& t : posed.triangles) {
    const auto is_distal = [&](std::uint32_t v) { return bones[v] == distal_bone(digit); };
    if (std::all_of(t.begin(), t.end(), is_distal)) skin.push_back(corners_of(posed, t));
  }
  return skin;
}

// A point of the skin in the frame of the digit's distal bone; it looks palmar.
std::optional<Vector3d> pulp_in_distal(const Hand& hand, int digit) {
  const auto d = static_cast<std::size_t>(digit);
  const RigidTransform& hand_from_bone = hand.hand_from_bone_at_bind[distal_bone(digit)];
  const Vector3d inside = .65 * hand.skeleton.tip_in_distal[d];
  const auto depth = distance_along(hand_from_bone * inside, -hand_from_bone.rotation.col(2),
                                    distal_skin(hand, hand.bind_mesh, digit));
  if (!depth) return std::nullopt;
  return Vector3d(inside - *depth * Vector3d::UnitZ());
}

void add_pulp_lines(const Hand& hand, int finger, std::vector<HandCheckLine>& lines) {
  const std::string gap = fmt::format("pulp gap, {}", finger_name(finger));
  const std::string facing = fmt::format("pulp facing, {}", finger_name(finger));
  const Gate gap_gate = at_most(1000 * kGapGate), facing_gate = at_most(degrees(kFacingGate));
  for (const int digit : {0, finger + 1}) {
    if (moves_skin(hand, distal_bone(digit))) continue;
    const std::string why = no_skin_on(distal_bone(digit));
    lines.push_back(not_applicable(gap, "mm", gap_gate, why));
    lines.push_back(not_applicable(facing, "deg", facing_gate, why));
    return;
  }
  const auto thumb = pulp_in_distal(hand, 0), other = pulp_in_distal(hand, finger + 1);
  if (!thumb || !other) {
    const std::string why = "no skin is palmar of the distal bone";
    lines.push_back(judged(gap, std::nan(""), "mm", gap_gate, why));
    lines.push_back(judged(facing, std::nan(""), "deg", facing_gate, why));
    return;
  }
  const Meeting best = best_meeting(hand.skeleton, {0, *thumb}, {finger + 1, *other});
  lines.push_back(judged(gap, 1000 * best.gap, "mm", gap_gate));
  lines.push_back(judged(facing, degrees(best.facing), "deg", facing_gate));
}

// The closed hand, and the skin that its fingertips should reach.
struct Fist {
  PerBone<RigidTransform> hand_from_bone;
  Mesh skin;
  std::vector<Corners> palm;
  double longest = 0;  // side of the palm's triangles

  explicit Fist(const Hand& hand);
  double distance_to_palm(const Vector3d& point, double at_most) const;
};

Fist::Fist(const Hand& hand)
    : hand_from_bone(hand_from_bones(hand.skeleton, named_pose("fist"))),
      skin(pose_skin(hand, hand_from_bone)) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const auto is_palm = [&](std::uint32_t v) {
    const int bone = bones[v];
    return bone == kPalm || bone == kThumbMetacarpal ||
           (bone >= kFirstFingerBone && (bone - kFirstFingerBone) % 4 == kMetacarpal);
  };
  for (const Triangle& t : skin.triangles) {
    if (!std::all_of(t.begin(), t.end(), is_palm)) continue;
    palm.push_back(corners_of(skin, t));
    longest = std::max(longest, longest_side(palm.back()));
  }
}

double Fist::distance_to_palm(const Vector3d& point, double at_most) const {
  for (const Corners& t : palm) {
    const double near_enough = at_most + longest;
    if ((t[0] - point).squaredNorm() > near_enough * near_enough) continue;
    at_most = std::min(at_most, distance_to_triangle(point, t));
  }
  return at_most;
}

HandCheckLine tip_to_palm(const Hand& hand, const Fist& fist, int finger) {
  const std::string name = fmt::format("tip to palm, {}", finger_name(finger));
  const int bone = finger_bone(finger, kDistal);
  if (!moves_skin(hand, bone)) {
    return not_applicable(name, "mm", at_most(3), no_skin_on(bone));
  }
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const RigidTransform bone_from_hand =
      fist.hand_from_bone[static_cast<std::size_t>(bone)].inverse();
  const double half = hand.skeleton.tip_in_distal[static_cast<std::size_t>(finger) + 1].y() / 2;
  double least = 1;
  for (std::size_t v = 0; v < fist.skin.vertices.size(); ++v) {
    const Vector3d point = fist.skin.vertices[v].cast<double>();
    if (bones[v] != bone || (bone_from_hand * point).y() < half) continue;
    least = fist.distance_to_palm(point, least);
  }
  return judged(name, 1000 * least, "mm", at_most(3));
}

}  // namespace

std::vector<HandCheckLine> check_reach(const Hand& hand) {
  std::vector<HandCheckLine> lines;
  for (int finger = 0; finger < kFingerCount; ++finger) add_pulp_lines(hand, finger, lines);
  const Fist fist(hand);
  for (int finger = 0; finger < kFingerCount; ++finger) {
    lines.push_back(tip_to_palm(hand, fist, finger));
  }
  return lines;
}

}  // namespace graspdb
