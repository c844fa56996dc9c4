// SPDX-License-Identifier: MIT
#include "graspdb/sequences/finding.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

// A millimetre is a pixel at the hand's distance.
constexpr Intrinsics kCamera{
    .width = 300, .height = 300, .fx = 500, .fy = 500, .cx = 150, .cy = 150};

// Fingers up, the arm down, the wrist in the middle; or turned towards the camera.
FrameTruth hand_at(double tilt) {
  FrameTruth truth;
  truth.camera_from_hand = {axis_rotation(0, kPi + tilt), {0, 0, 0.5}};
  truth.angles.setZero();
  return truth;
}

// From 100 mm above the wrist to `end` below.
Mask hand_until(int end) {
  Mask mask(300, 300);
  for (int y = 50; y < 150 + end; ++y) std::fill(mask.row(y) + 110, mask.row(y) + 190, 255);
  return mask;
}

Finding compare(const Mask& found, const Mask& truth, double tilt = 0) {
  return compare_masks(found, truth, hand_at(tilt), testing::toy_skeleton(), kCamera);
}

TEST(Finding, OfTheTrueMaskIsPerfect) {
  const Finding finding = compare(hand_until(15), hand_until(15));
  EXPECT_EQ(finding.iou, 1);
  EXPECT_EQ(finding.wrist_mm, 0);
  EXPECT_FALSE(finding.missed || finding.imagined);
}

TEST(Finding, TellsHowFarTheWristIsOff) {
  EXPECT_NEAR(compare(hand_until(55), hand_until(15)).wrist_mm, 40, 2);
  EXPECT_NEAR(compare(hand_until(0), hand_until(15)).wrist_mm, 15, 2);
}

TEST(Finding, WhatLiesBesideTheArmIsNotItsEnd) {
  Mask found = hand_until(15);
  for (int y = 200; y < 300; ++y) std::fill(found.row(y) + 250, found.row(y) + 300, 255);
  EXPECT_EQ(compare(found, hand_until(15)).wrist_mm, 0);
}

TEST(Finding, AnArmThatPointsAtTheCameraHasNoEnd) {
  EXPECT_TRUE(std::isnan(compare(hand_until(15), hand_until(15), radians(80)).wrist_mm));
}

TEST(Finding, AHandIsMissedOrImagined) {
  const Mask nothing(300, 300);
  EXPECT_TRUE(compare(nothing, hand_until(15)).missed);
  EXPECT_EQ(compare(nothing, hand_until(15)).iou, 0);
  EXPECT_TRUE(compare(hand_until(15), nothing).imagined);
  const Finding neither = compare(nothing, nothing);
  EXPECT_TRUE(std::isnan(neither.iou));
  EXPECT_FALSE(neither.missed || neither.imagined);
}

}  // namespace
}  // namespace graspdb
