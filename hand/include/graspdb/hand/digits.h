// SPDX-License-Identifier: MIT
// The five digits: their names, their bones, and the one place where the ways to number them meet:
//   digit            0 thumb, 1 index .. 4 little: wherever nothing else is said
//   finger           0 index .. 3 little: what has four alike, see kFingerCount and finger_bone
//   palm or digit    0 palm, 1 thumb, 2 index .. 5 little: in grasps/, where the palm touches
//                    objects too; the digits have the numbers that hand surgeons give them
#pragma once

#include <array>
#include <string_view>

#include "graspdb/core/error.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

constexpr int kDigitCount = 5;
constexpr int kPalmAndDigitCount = 6;
constexpr std::array<std::string_view, kPalmAndDigitCount> kPalmAndDigitNames = {
    "palm", "thumb", "index", "middle", "ring", "little"};

constexpr int digit_of_finger(int finger) {
  return finger + 1;
}
constexpr int with_palm(int digit) {  // digit to "palm or digit"
  return digit + 1;
}
constexpr int without_palm(int palm_or_digit) {  // and back
  return palm_or_digit - 1;
}

inline std::string_view palm_or_digit_name(int palm_or_digit) {
  GRASPDB_CHECK(palm_or_digit >= 0 && palm_or_digit < kPalmAndDigitCount);
  return kPalmAndDigitNames[static_cast<std::size_t>(palm_or_digit)];
}
inline std::string_view digit_name(int digit) {
  GRASPDB_CHECK(digit >= 0);
  return palm_or_digit_name(with_palm(digit));
}
inline std::string_view finger_name(int finger) {
  GRASPDB_CHECK(finger >= 0);
  return digit_name(digit_of_finger(finger));
}

// The three bones that reach a digit's tip, from the thumb's metacarpal or a finger's proximal
// phalanx on, have consecutive numbers.
constexpr int first_bone(int digit) {
  return digit == 0 ? kThumbMetacarpal : finger_bone(digit - 1, kProximal);
}
constexpr int distal_bone(int digit) {
  return first_bone(digit) + 2;
}
constexpr int tip_keypoint(int digit) {
  return 4 * digit + 4;
}

}  // namespace graspdb
