// SPDX-License-Identifier: MIT
// Makes a skinned hand from a few measures: a surface of smoothly blended tapered capsules, meshed
// in a mid-range pose, with analytic skin weights.
#pragma once

#include <filesystem>
#include <string>

#include "graspdb/hand.h"

namespace graspdb {

struct HandShape {
  std::string name = "male";
  double length_mm = 193;    // wrist joint to middle fingertip along the straight hand
  double breadth_mm = 88;    // across the knuckles without the thumb
  double finger_length = 1;  // factors on the proportions that follow from the two lengths
  double finger_thickness = 1;
  double palm_thickness = 1;
  double forearm_thickness = 1;
  double forearm_length_mm = 180;  // beyond the wrist joint
};

// The four default hands by name: male, female, slender, child. Throws Error for another name.
HandShape default_hand_shape(const std::string& name);

// Deterministic: the same shape gives the same bytes on the same kind of machine. Takes about a
// second on two processors. Throws Error naming a measure that no hand has, or when the fingers are
// so thick that they touch in the bind pose.
Hand make_hand(const HandShape& shape);

// Writes hand.glb and its rig map hand.rig.toml beside it, both aside and renamed.
void write_hand(const Hand& hand, const std::filesystem::path& glb);

}  // namespace graspdb
