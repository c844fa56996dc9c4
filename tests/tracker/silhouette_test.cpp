// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace graspdb {
namespace {

constexpr Intrinsics kView{
    .width = 320, .height = 240, .fx = 300, .fy = 300, .cx = 159.5, .cy = 119.5};
const Eigen::Vector3d kPalmAt(0.02, -0.01, 0.5);
constexpr double kPalmLengthM = 0.09;

// A right hand whose palm faces the camera, fingers down in the picture.
PosedHand flat_hand() {
  constexpr std::array<std::array<double, 2>, kKeypointCount> kMillimeters = {
      {{0, 0},     {-22, 22},  {-50, 56}, {-70, 80}, {-86, 100}, {-24, 90}, {-24, 132},
       {-24, 157}, {-24, 178}, {-2, 91},  {-2, 137}, {-2, 165},  {-2, 187}, {17, 85},
       {17, 127},  {17, 153},  {17, 175}, {34, 76},  {34, 109},  {34, 128}, {34, 148}}};
  Keypoints joints = Keypoints::Zero();
  for (int i = 0; i < kKeypointCount; ++i)
    joints.col(i).head<2>() = Eigen::Vector2d(kMillimeters[i][0], kMillimeters[i][1]) / 1000;
  return {joints.colwise() - palm_center(joints), 0.19};
}

// The hand and a stump of its arm as balls along its bones.
Mask picture_of(const PosedHand& hand, const Eigen::Vector3d& palm, double arm_m = 0.015) {
  Keypoints joints = hand.from_palm.colwise() + palm;
  Mask mask(kView.width, kView.height);
  const auto ball = [&](const Eigen::Vector3d& center, double radius) {
    const Eigen::Vector2d middle = kView.project(center);
    const double reach = radius * kView.fx / center.z();
    for (int y = 0; y < mask.height(); ++y) {
      for (int x = 0; x < mask.width(); ++x) {
        if ((Eigen::Vector2d(x, y) - middle).norm() <= reach) mask.at(x, y) = 255;
      }
    }
  };
  const auto bone = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
    for (double share = 0; share <= 1; share += 0.1) ball(from + share * (to - from), radius);
  };
  for (int finger = 0; finger < 5; ++finger) {
    for (int i = 1; i < 4; ++i)
      bone(joints.col(4 * finger + i), joints.col(4 * finger + i + 1), 0.009);
  }
  for (double share = 0; share <= 1; share += 0.2) {
    const Eigen::Vector3d edge = (1 - share) * joints.col(5) + share * joints.col(17);
    bone(joints.col(0), edge, 0.012);
  }
  bone(joints.col(0), joints.col(1), 0.012);
  bone(joints.col(0), joints.col(0) - Eigen::Vector3d(0, arm_m, 0), 0.026);
  return mask;
}

Eigen::Vector3d laid(const Mask& mask, const Eigen::Vector3d& from) {
  return laid_over(mask, tight_box(mask).value(), kView, flat_hand(), from, 0.33);
}

double off_in_picture_palms(const Eigen::Vector3d& palm) {
  const double palm_px = kPalmLengthM * kView.fx / kPalmAt.z();
  return (kView.project(palm) - kView.project(kPalmAt)).norm() / palm_px;
}

TEST(Silhouette, AHandThatCoversWhatIsSeenStays) {
  const Eigen::Vector3d palm = laid(picture_of(flat_hand(), kPalmAt), kPalmAt);
  EXPECT_LT(off_in_picture_palms(palm), 0.1);
  EXPECT_NEAR(palm.z() / kPalmAt.z(), 1, 1e-6);
}

TEST(Silhouette, AHandBesideWhatIsSeenIsLaidOverIt) {
  const Mask mask = picture_of(flat_hand(), kPalmAt);
  for (const Eigen::Vector3d& off : {Eigen::Vector3d(0.03, 0, 0), Eigen::Vector3d(-0.02, 0.03, 0),
                                     Eigen::Vector3d(0.01, -0.04, 0)}) {
    ASSERT_GT(off_in_picture_palms(kPalmAt + off), 0.3);
    EXPECT_LT(off_in_picture_palms(laid(mask, kPalmAt + off)),
              0.5 * off_in_picture_palms(kPalmAt + off))
        << off.transpose();
  }
}

// (One taken for nearer covers all, and may be hidden.)
TEST(Silhouette, AHandTakenForFurtherThanItIsIsDrawnNearer) {
  const Mask mask = picture_of(flat_hand(), kPalmAt);
  EXPECT_NEAR(laid(mask, 1.12 * kPalmAt).z() / kPalmAt.z(), 1, 0.06);
}

// An object before the fingers: nothing is seen of them.
TEST(Silhouette, WhatAnObjectHidesNeedNotBeSeen) {
  Mask mask = picture_of(flat_hand(), kPalmAt);
  const int middle = static_cast<int>(kView.project(kPalmAt).y()) + 25;
  for (int y = middle; y < mask.height(); ++y) std::fill_n(mask.row(y), mask.width(), 0);
  EXPECT_LT(off_in_picture_palms(laid(mask, kPalmAt)), 0.1);
  EXPECT_LT(off_in_picture_palms(laid(mask, kPalmAt + Eigen::Vector3d(0.02, 0.02, 0))), 0.2);
}

TEST(Silhouette, MoreOfTheArmDoesNotPullTheHandAlong) {
  const Mask mask = picture_of(flat_hand(), kPalmAt, 0.05);
  EXPECT_LT(off_in_picture_palms(laid(mask, kPalmAt)), 0.12);
}

TEST(Silhouette, AHandHalfOutsideThePictureIsNotPulledIn) {
  const double left = (20 - kView.cx) / kView.fx * kPalmAt.z();  // 20 pixels from the border
  const Eigen::Vector3d at(left, kPalmAt.y(), kPalmAt.z());
  const Eigen::Vector3d palm = laid(picture_of(flat_hand(), at), at);
  EXPECT_LT((kView.project(palm) - kView.project(at)).norm(), 6);
}

TEST(Silhouette, MovesAreBounded) {
  const Mask mask = picture_of(flat_hand(), kPalmAt);
  const Box box = tight_box(mask).value();
  const Eigen::Vector3d off(0.05, 0, 0);
  for (const double reach : {0.05, 0.1, 0.2}) {
    const Eigen::Vector3d palm = laid_over(mask, box, kView, flat_hand(), kPalmAt + off, reach);
    const double moved = (kView.project(palm) - kView.project(kPalmAt + off)).x();
    EXPECT_LT(moved, -1) << reach;
    // The size, too, moves the palm about the middle of the keypoints.
    EXPECT_GT(moved, -(reach * std::max(box.width, box.height) + 4)) << reach;
  }
}

TEST(Silhouette, WithoutACellThatIsSeenTheHandStays) {
  Mask thin(kView.width, kView.height);
  for (int i = 0; i < 200; ++i) thin.at(60 + i, 20 + i) = 255;
  EXPECT_EQ(laid(thin, kPalmAt), kPalmAt);
}

TEST(Silhouette, APlaceThatIsNoNumberStays) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d palm = laid(picture_of(flat_hand(), kPalmAt), {nan, 0, 0.5});
  EXPECT_TRUE(std::isnan(palm.x()));
  EXPECT_EQ(palm.z(), 0.5);
}

TEST(Silhouette, AHandThatWouldReachBehindTheCameraStays) {
  PosedHand hand = flat_hand();
  hand.from_palm.row(2).setConstant(-0.6);
  const Mask mask = picture_of(flat_hand(), kPalmAt);
  EXPECT_EQ(laid_over(mask, tight_box(mask).value(), kView, hand, kPalmAt, 0.33), kPalmAt);
}

}  // namespace
}  // namespace graspdb
