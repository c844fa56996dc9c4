// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "graspdb/hand/hand.h"
#include "support/toy_skeleton.h"

namespace graspdb::testing {

// Adds a closed capsule along y of a bone's frame, moved by that bone alone.
inline void add_capsule(Hand& hand, int bone, double length, double radius) {
  constexpr int kAround = 8, kRings = 9;
  const RigidTransform& hand_from_bone =
      hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)];
  Mesh& mesh = hand.bind_mesh;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int ring = 0; ring <= kRings; ++ring) {
    // A third of the rings for each half ball, the rest along the shaft between them.
    const double third = 3.0 * ring / kRings;
    const double polar = kPi / 2 * (std::min(third, 1.0) + std::max(third - 2, 0.0));
    const double shift = length * std::clamp(third - 1, 0.0, 1.0);
    for (int i = 0; i < kAround; ++i) {
      const double turn = 2 * kPi * i / kAround;
      const Eigen::Vector3d normal(std::sin(polar) * std::cos(turn), -std::cos(polar),
                                   -std::sin(polar) * std::sin(turn));
      const Eigen::Vector3d point = radius * normal + Eigen::Vector3d(0, shift, 0);
      mesh.vertices.push_back((hand_from_bone * point).cast<float>());
      mesh.normals.push_back((hand_from_bone.rotation * normal).cast<float>());
      SkinWeights weights;
      weights.bone[0] = static_cast<std::uint8_t>(bone);
      weights.weight[0] = 1;
      hand.weights.push_back(weights);
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = first + ring * kAround, next = (i + 1) % kAround;
      mesh.triangles.push_back({a + i, a + next, a + kAround + next});
      mesh.triangles.push_back({a + i, a + kAround + next, a + kAround + i});
    }
  }
}

// A hand of one capsule a bone on the toy skeleton, bound flat.
inline Hand toy_hand() {
  Hand hand;
  hand.name = "toy";
  hand.skeleton = toy_skeleton();
  hand.hand_from_bone_at_bind = hand_from_bones(hand.skeleton, JointAngles::Zero());
  add_capsule(hand, kThumbMetacarpal, 0.045, 0.012);
  add_capsule(hand, kThumbProximal, 0.035, 0.010);
  add_capsule(hand, kThumbDistal, 0.021, 0.009);
  constexpr std::array<double, 4> kLengths = {0.065, 0.040, 0.025, 0.012};
  for (int f = 0; f < kFingerCount; ++f) {
    add_capsule(hand, finger_bone(f, kMetacarpal), kLengths[0], 0.011);
    for (const FingerBone b : {kProximal, kMiddle, kDistal}) {
      add_capsule(hand, finger_bone(f, b), kLengths[b], 0.0085);
    }
  }
  return hand;
}

}  // namespace graspdb::testing
