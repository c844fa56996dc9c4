// SPDX-License-Identifier: MIT
#include "stated.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "graspdb/geometry/triangle.h"
#include "graspdb/hand/witness/palm_side.h"
#include "lines.h"

namespace graspdb {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

HandCheckLine palm_side(const Hand& hand) {
  using enum PalmWitness::Verdict;
  const std::vector<PalmWitness> witnesses = palm_witnesses(hand);
  const Gate gate = exactly(0);
  if (count_of(witnesses, kTellsNothing) == std::ssize(witnesses)) {
    return not_applicable("palm side, signs against it", "", gate, "no sign tells");
  }
  return judged("palm side, signs against it",
                static_cast<double>(count_of(witnesses, kContradicts)), "", gate,
                seen_by(witnesses, kContradicts));
}

// Triangles of one bone's skin, in its frame.
std::vector<Corners> skin_in_bone(const Hand& hand, int bone) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const RigidTransform bone_from_hand =
      hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)].inverse();
  std::vector<Corners> skin;
  for (const Triangle& t : hand.bind_mesh.triangles) {
    const auto is_of_bone = [&](std::uint32_t v) { return bones[v] == bone; };
    if (!std::all_of(t.begin(), t.end(), is_of_bone)) continue;
    Corners corners = corners_of(hand.bind_mesh, t);
    for (Vector3d& corner : corners) corner = bone_from_hand * corner;
    skin.push_back(corners);
  }
  return skin;
}

// How much skin between joint and tip faces which way, seen along the bone: x and z of its frame,
// weighed by area.
Matrix2d facing_round(const Hand& hand, int digit) {
  const double length = hand.skeleton.tip_in_distal[static_cast<std::size_t>(digit)].y();
  Matrix2d facing = Matrix2d::Zero();
  for (const Corners& triangle : skin_in_bone(hand, distal_bone(digit))) {
    const double along = (triangle[0] + triangle[1] + triangle[2]).y() / 3;
    const Vector3d normal = normal_of(triangle);
    if (!(along > .2 * length && along < .85 * length && normal.norm() > 0)) continue;
    const Vector2d across(normal.x(), normal.z());
    facing += across * across.transpose() / normal.norm();
  }
  return facing;
}

// A digit's end is flat on its nail and on its pulp. Between that and what the frame has for
// dorsal, 0..90 degrees; nothing for an end that is round.
std::optional<double> nail_off(const Hand& hand, int digit) {
  constexpr double kRound = 1.05;
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(facing_round(hand, digit));
  if (!(axes.eigenvalues()[1] > kRound * axes.eigenvalues()[0])) return std::nullopt;
  const Vector2d flat = axes.eigenvectors().col(1).cwiseAbs();
  return degrees(std::atan2(flat.x(), flat.y()));
}

HandCheckLine worst_nail(const Hand& hand, const std::string& name, int first, int last,
                         const Gate& gate) {
  Worst worst;
  std::string round;
  for (int digit = first; digit <= last; ++digit) {
    if (const auto off = nail_off(hand, digit)) {
      worst.take(*off, [&] { return std::string(digit_name(digit)); });
    } else {
      round = fmt::format("the {}'s end is round or bare", digit_name(digit));
    }
  }
  HandCheckLine line = judged(name, worst.value, "deg", gate, worst.where);
  if (round.empty() || line.status == HandCheckLine::Status::kFail) return line;
  return not_applicable(name, "deg", gate, round);
}

// How far a digit's tip lies from the skin of its last bone, or before the end of it.
double tip_off_skin(const std::vector<Corners>& skin, const Vector3d& tip) {
  double distance = std::numeric_limits<double>::infinity(), end = 0;
  for (const Corners& triangle : skin) {
    distance = std::min(distance, distance_to_triangle(tip, triangle));
    for (const Vector3d& corner : triangle) end = std::max(end, corner.y());
  }
  return std::max(distance, end - tip.y());
}

HandCheckLine tips_on_skin(const Hand& hand) {
  Worst worst;
  Missing missing;
  for (int digit = 0; digit < kDigitCount; ++digit) {
    if (missing.lacks_skin(hand, distal_bone(digit))) continue;
    const Vector3d& tip = hand.skeleton.tip_in_distal[static_cast<std::size_t>(digit)];
    worst.take(1000 * tip_off_skin(skin_in_bone(hand, distal_bone(digit)), tip),
               [&] { return std::string(digit_name(digit)); });
  }
  return judged_unless(missing, "tips on the skin", worst, "mm", at_most(3));
}

}  // namespace

std::vector<HandCheckLine> check_stated(const Hand& hand) {
  return {palm_side(hand), worst_nail(hand, "nail, thumb", 0, 0, at_most(25)),
          worst_nail(hand, "nail, fingers", 1, kDigitCount - 1, at_most(35)), tips_on_skin(hand)};
}

}  // namespace graspdb
