// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "graspdb/core/transform.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {
namespace {

// A drawn arm at 1 pixel a millimetre, scaled: elbow below, wrist at `wrist_px`, palm and fingers
// beyond it along `direction`.
struct Arm {
  int width = 640, height = 480;
  Eigen::Vector2d wrist_px{320, 260};
  double direction_deg = -90;  // up in the picture
  double px_per_mm = 1;
  bool fist = false;
  double forearm_mm = 400;
};

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

// Coordinates: x along the arm from the wrist to the fingers, y across, millimetres.
bool inside(const Arm& arm, const Eigen::Vector2d& p) {
  const double taper = std::min(45.0, 28.0 + 0.08 * std::max(0.0, -p.x()));
  if (p.x() <= 20 && p.x() >= -arm.forearm_mm && std::abs(p.y()) <= taper) return true;
  const double palm = std::min(42.0, 28.0 + 0.35 * p.x());
  if (p.x() >= 0 && p.x() <= 85 && std::abs(p.y()) <= palm) return true;
  if (arm.fist) return false;
  for (int f = 0; f < 4; ++f) {
    const double side = -30 + 20 * f;
    if (distance_to_segment(p, {60, side}, {165, 1.5 * side}) <= 8.5) return true;
  }
  return distance_to_segment(p, {40, -35}, {90, -75}) <= 10;
}

// For every pixel, where it is along the arm.
template <typename Visit>
void for_each_pixel(const Arm& arm, Visit visit) {
  const double c = std::cos(radians(arm.direction_deg)), s = std::sin(radians(arm.direction_deg));
  for (int y = 0; y < arm.height; ++y) {
    for (int x = 0; x < arm.width; ++x) {
      const Eigen::Vector2d d = (Eigen::Vector2d(x, y) - arm.wrist_px) / arm.px_per_mm;
      visit(x, y, Eigen::Vector2d(c * d.x() + s * d.y(), -s * d.x() + c * d.y()));
    }
  }
}

Mask draw(const Arm& arm) {
  Mask mask(arm.width, arm.height);
  for_each_pixel(arm, [&](int x, int y, const Eigen::Vector2d& p) {
    mask.at(x, y) = inside(arm, p) ? 255 : 0;
  });
  return mask;
}

// The hand stays whole and the arm is cut some 22 mm before the wrist.
void expect_cut(const Arm& arm) {
  const Mask mask = draw(arm), cut = cut_forearm(mask);
  int lost_hand = 0;
  double least = 0;
  for_each_pixel(arm, [&](int x, int y, const Eigen::Vector2d& p) {
    lost_hand += p.x() > 0 && mask.at(x, y) != cut.at(x, y);
    if (cut.at(x, y) != 0) least = std::min(least, p.x());
    EXPECT_LE(cut.at(x, y), mask.at(x, y));
  });
  EXPECT_EQ(lost_hand, 0);
  EXPECT_LT(least, -8);
  EXPECT_GT(least, -45);
}

TEST(CutForearm, AnOpenHandKeepsAllAndAStumpOfItsArm) {
  expect_cut({});
}

TEST(CutForearm, AFistOnAThickForearmKeepsAll) {
  expect_cut({.wrist_px = {320, 150}, .px_per_mm = 1.2, .fist = true, .forearm_mm = 400});
}

TEST(CutForearm, AnySideSlantAndSize) {
  expect_cut({.wrist_px = {300, 250}, .direction_deg = 0});
  expect_cut({.wrist_px = {300, 180}, .direction_deg = 90});
  expect_cut({.wrist_px = {380, 240}, .direction_deg = 160});
  expect_cut({.wrist_px = {340, 260}, .direction_deg = -60, .px_per_mm = 0.8});
  expect_cut({.width = 1280, .height = 720, .wrist_px = {640, 420}, .px_per_mm = 1.5});
  expect_cut({.width = 161, .height = 121, .wrist_px = {80, 75}, .px_per_mm = 0.4});
}

TEST(CutForearm, AnArmThatDoesNotReachTheBorderStays) {
  const Mask mask = draw({.forearm_mm = 100});
  EXPECT_EQ(cut_forearm(mask), mask);
}

TEST(CutForearm, FingertipsOnTheBorderAreNoArm) {
  const Mask mask = draw({.wrist_px = {320, 165}, .forearm_mm = 100});
  EXPECT_EQ(mask.at(275, 0), 255);
  EXPECT_EQ(cut_forearm(mask), mask);
}

TEST(CutForearm, AnEmptyAndAFullMaskStay) {
  EXPECT_EQ(cut_forearm(Mask(64, 48)), Mask(64, 48));
  EXPECT_EQ(cut_forearm(Mask(64, 48, 255)), Mask(64, 48, 255));
}

}  // namespace
}  // namespace graspdb
