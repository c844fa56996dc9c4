// SPDX-License-Identifier: MIT
// Where the flesh lies on the bones of a hand.
#pragma once

#include <array>

#include "capsule.h"
#include "graspdb/hand/maker/hand_maker.h"

namespace graspdb {

// Bone frames with millimetre origins.
using BoneFramesMm = PerBone<RigidTransform>;

// How the flesh differs from the tables': across the hand, across the digits, through the palm and
// across the forearm. All 1 for a hand of the measures in proportions.h.
struct FleshScales {
  double width, digit, palm, forearm;
};

// A nail lies on the back of a last phalanx.
struct Nail {
  RigidTransform hand_from_distal;
  double middle_y, half_length, half_breadth;
};
// 0 in its middle, 1 on its edge, between an ellipse and a rectangle; infinite on the palmar side.
double distance_from_nail(const Nail& nail, const Eigen::Vector3d& point);

struct HandFlesh {
  std::array<Flesh, 5> digits;  // thumb, index, middle, ring, little: phalanges only
  Flesh palm;                   // with metacarpals, thenar, webs
  Flesh forearm;
  std::array<Nail, 5> nails;
  std::array<FleshCapsule, 5> rays;  // metacarpals as they are, to divide the palm among them
};

// `frames` are those of the pose in which the flesh is wanted; `tips_mm` lie in their distal bone.
HandFlesh flesh_of_shape(const HandShape& shape, const FleshScales& scales,
                         const BoneFramesMm& frames, const std::array<Eigen::Vector3d, 5>& tips_mm);

}  // namespace graspdb
