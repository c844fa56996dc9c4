// SPDX-License-Identifier: MIT
// Makes a skinned hand from a few measures: a surface of smoothly blended tapered capsules, meshed
// in a mid-range pose, with analytic skin weights.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "graspdb/hand/hand.h"

namespace graspdb {

// Millimetres, of the flat hand. Each is what is measured on the skin that is made, length and
// breadth within 1 %, the others within 3 %.
struct HandShape {
  std::string name = "male";
  double length_mm = 193;           // wrist joint to middle fingertip
  double breadth_mm = 88;           // across the knuckles without the thumb
  double finger_length_mm = 106;    // of the middle finger, from its MCP joint to its tip
  double finger_breadth_mm = 20.5;  // of the index finger at its PIP joint
  double palm_thickness_mm = 28;    // through the middle of the middle finger's metacarpal
  double forearm_breadth_mm = 59;   // just behind the wrist, an eighth of the hand's length from it
  double forearm_length_mm = 180;   // beyond the wrist joint
};

inline const std::array<std::string, 4> kDefaultHands = {"male", "female", "slender", "child"};

// The default hands by name. Throws Error for another name.
HandShape default_hand_shape(const std::string& name);

// Between what a measure may be, mm, from the smallest to the largest hand. Each hand must also be
// in proportion, which make_hand checks.
struct MeasureRange {
  double low, high;
};
struct MeasureRanges {
  MeasureRange length_mm{100, 240}, breadth_mm{36, 130}, finger_length_mm{49, 144},
      finger_breadth_mm{6, 34}, palm_thickness_mm{9, 55}, forearm_breadth_mm{18, 113},
      forearm_length_mm{60, 300};
};
constexpr MeasureRanges kMeasureRanges;

// What is wanted of a hand. Measures that are not named stay in proportion to the base hand's:
// breadth and what runs along the hand to the length, what runs across it to the breadth.
struct WantedMeasures {
  std::optional<double> length_mm, breadth_mm, finger_length_mm, finger_breadth_mm,
      palm_thickness_mm, forearm_breadth_mm, forearm_length_mm;
};
HandShape in_proportion(const HandShape& base, const WantedMeasures& wanted);

// Deterministic: the same shape gives the same bytes on the same kind of machine. Takes about
// half a second on two processors. `coarseness` is at least 1: edges that many times as long, for
// where hands are needed in number and seen from afar. Throws Error naming a measure that no hand
// has, or when the fingers are so thick that they touch in the bind pose.
Hand make_hand(const HandShape& shape, double coarseness = 1);

// Writes hand.glb and its rig map hand.rig.toml beside it, both aside and renamed. Throws Error
// when a rig map is there that was not written so: a person may have filled it in.
void write_hand(const Hand& hand, const std::filesystem::path& glb);

}  // namespace graspdb
