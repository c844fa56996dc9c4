// SPDX-License-Identifier: MIT
#include "graspdb/hand/witness/palm_side.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "graspdb/geometry/triangle.h"
#include "graspdb/hand/digits.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;
using Verdict = PalmWitness::Verdict;

// What a sign must exceed to tell anything. The least that our four hands, 28 made at random,
// WebXR's and MakeHuman's have at rest, at zero or bent back: the root 3.1 % of the hand's length
// palmar, 55 % of the palm's flesh and 53.4 % of the fingertips'; WebXR's fingers rest bent back by
// 7 degrees.
constexpr double kSureRoot = .015;  // of the hand's length
constexpr double kSureBend = radians(30);
constexpr double kSurePalm = .03, kSureFingertips = .025;  // beyond half of the flesh

PalmWitness witness(std::string seen, double sign, double sure) {
  const Verdict verdict = sign > sure    ? Verdict::kAgrees
                          : sign < -sure ? Verdict::kContradicts
                                         : Verdict::kTellsNothing;
  return {std::move(seen), verdict};
}

Vector3d origin(const Hand& hand, int bone) {
  return hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)].translation;
}

Vector3d far_end(const Hand& hand, int bone, int digit) {
  if (bone < distal_bone(digit)) return origin(hand, bone + 1);
  const auto b = static_cast<std::size_t>(bone);
  return hand.hand_from_bone_at_bind[b] *
         hand.skeleton.tip_in_distal[static_cast<std::size_t>(digit)];
}

// Of the plane through the wrist and the two outer knuckles.
Vector3d dorsal_of_knuckles(const Hand& hand) {
  const Vector3d wrist = origin(hand, kPalm);
  return (origin(hand, finger_bone(3, kProximal)) - wrist)
      .cross(origin(hand, finger_bone(0, kProximal)) - wrist)
      .normalized();
}

PalmWitness by_thumb(const Hand& hand) {
  const double depth =
      dorsal_of_knuckles(hand).dot(origin(hand, kPalm) - origin(hand, kThumbMetacarpal));
  return witness(fmt::format("the thumb's root {:.0f} mm {} of wrist and knuckles",
                             1000 * std::abs(depth), depth < 0 ? "dorsal" : "palmar"),
                 depth / hand_length(hand.skeleton), kSureRoot);
}

// From one bone to the next, about the axis that all fingers bend about.
double bend_after(const Hand& hand, int bone, int digit) {
  const Vector3d before = (far_end(hand, bone, digit) - origin(hand, bone)).normalized();
  const Vector3d after = (far_end(hand, bone + 1, digit) - origin(hand, bone + 1)).normalized();
  return std::asin(std::clamp(-before.cross(after).x(), -1., 1.));
}

PalmWitness by_bend(const Hand& hand) {
  double bend = 0;
  for (int finger = 0; finger < kFingerCount; ++finger) {
    for (const FingerBone part : {kProximal, kMiddle}) {
      bend += bend_after(hand, finger_bone(finger, part), digit_of_finger(finger)) / kFingerCount;
    }
  }
  return witness(fmt::format("the fingers bent {:.0f} degrees to the {}", degrees(std::abs(bend)),
                             bend < 0 ? "back" : "palm"),
                 bend, kSureBend);
}

// How thick the skin lies on both sides of some bones.
struct Flesh {
  double palmar = 0, dorsal = 0;

  // In the middle of the way, far from the joints.
  void add(const Vector3d& from, const Vector3d& to, const Vector3d& back,
           std::span<const Corners> skin) {
    for (const double share : {.3, .4, .5, .6, .7}) {
      const Vector3d inside = from + share * (to - from);
      const auto below = distance_along(inside, -back, skin);
      const auto above = distance_along(inside, back, skin);
      if (!below || !above) continue;
      palmar += *below;
      dorsal += *above;
    }
  }

  PalmWitness witness(const std::string& of_what, double sure) const {
    const double all = palmar + dorsal;
    if (!(all > 0)) return {"", Verdict::kTellsNothing};
    const double share = palmar / all;
    return graspdb::witness(fmt::format("{:.0f} % of {} palmar of the bones", 100 * share, of_what),
                            share - .5, sure);
  }
};

std::vector<Corners> skin_of(const Hand& hand, const auto& takes_bone) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::vector<Corners> skin;
  for (const Triangle& t : hand.bind_mesh.triangles) {
    const auto is_taken = [&](std::uint32_t v) { return takes_bone(bones[v]); };
    if (std::all_of(t.begin(), t.end(), is_taken)) skin.push_back(corners_of(hand.bind_mesh, t));
  }
  return skin;
}

bool is_of_palm(int bone) {
  return bone == kPalm || bone == kThumbMetacarpal ||
         (bone >= kFirstFingerBone && (bone - kFirstFingerBone) % 4 <= kProximal);
}

PalmWitness by_palm(const Hand& hand) {
  const std::vector<Corners> skin = skin_of(hand, is_of_palm);
  const Vector3d back = dorsal_of_knuckles(hand), wrist = origin(hand, kPalm);
  Flesh flesh;
  for (int finger = 0; finger < kFingerCount; ++finger) {
    const Vector3d knuckle = origin(hand, finger_bone(finger, kProximal));
    flesh.add(wrist + .4 * (knuckle - wrist), knuckle, back, skin);
  }
  return flesh.witness("the palm's flesh", kSurePalm);
}

PalmWitness by_fingertips(const Hand& hand) {
  Flesh flesh;
  for (int digit = 1; digit < kDigitCount; ++digit) {
    const int bone = distal_bone(digit);
    const Vector3d back =
        hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)].rotation.col(2);
    const auto is_near = [&](int other) { return other == bone || other == bone - 1; };
    flesh.add(origin(hand, bone), far_end(hand, bone, digit), back, skin_of(hand, is_near));
  }
  return flesh.witness("the fingertips' flesh", kSureFingertips);
}

}  // namespace

std::vector<PalmWitness> palm_witnesses(const Hand& hand) {
  return {by_thumb(hand), by_bend(hand), by_palm(hand), by_fingertips(hand)};
}

std::ptrdiff_t count_of(const std::vector<PalmWitness>& witnesses, Verdict verdict) {
  return std::ranges::count(witnesses, verdict, &PalmWitness::verdict);
}

std::string seen_by(const std::vector<PalmWitness>& witnesses, Verdict verdict) {
  std::string all;
  for (const PalmWitness& witness : witnesses) {
    if (witness.verdict != verdict) continue;
    all += (all.empty() ? "" : ", ") + witness.seen;
  }
  return all;
}

}  // namespace graspdb
