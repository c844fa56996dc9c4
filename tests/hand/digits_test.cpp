// SPDX-License-Identifier: MIT
#include "graspdb/hand/digits.h"

#include <gtest/gtest.h>

namespace graspdb {
namespace {

TEST(Digits, EachNumberingNamesTheSameDigits) {
  EXPECT_EQ(digit_name(0), "thumb");
  EXPECT_EQ(digit_name(4), "little");
  EXPECT_EQ(finger_name(0), "index");
  EXPECT_EQ(finger_name(3), "little");
  EXPECT_EQ(palm_or_digit_name(0), "palm");
  for (int digit = 0; digit < kDigitCount; ++digit) {
    EXPECT_EQ(palm_or_digit_name(with_palm(digit)), digit_name(digit));
    EXPECT_EQ(without_palm(with_palm(digit)), digit);
  }
  for (int finger = 0; finger < kFingerCount; ++finger)
    EXPECT_EQ(digit_name(digit_of_finger(finger)), finger_name(finger));
}

TEST(Digits, BonesAndKeypointsOfADigitBearItsName) {
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const std::string name(digit_name(digit));
    EXPECT_EQ(bone_name(first_bone(digit)), name + (digit == 0 ? "_metacarpal" : "_proximal"));
    EXPECT_EQ(bone_name(distal_bone(digit)), name + "_distal");
    EXPECT_EQ(keypoint_name(tip_keypoint(digit)), name + "_tip");
  }
}

TEST(Digits, ADigitThatThereIsNotIsAMistakeOfOurs) {
  EXPECT_THROW(digit_name(-1), std::logic_error);
  EXPECT_THROW(digit_name(5), std::logic_error);
  EXPECT_THROW(finger_name(4), std::logic_error);
  EXPECT_THROW(palm_or_digit_name(6), std::logic_error);
}

}  // namespace
}  // namespace graspdb
