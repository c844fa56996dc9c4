// SPDX-License-Identifier: MIT
#include "placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace graspdb {
namespace {

constexpr Intrinsics kAnyCamera{
    .width = 640, .height = 480, .fx = 500, .fy = 500, .cx = 319.5, .cy = 239.5};
constexpr BoxTangents kRowBox{.x = -0.1F, .y = -0.1F, .width = 0.2F, .height = 0.2F};

// The box of whole pixels from (u, v) - half to (u, v) + half.
Box box_around(double u, double v, double half) {
  return {static_cast<int>(std::lround(u - half + 0.5)),
          static_cast<int>(std::lround(v - half + 0.5)), static_cast<int>(std::lround(2 * half)),
          static_cast<int>(std::lround(2 * half))};
}

TEST(Placement, ABoxAsLargeAsTheRowsIsAsFarAway) {
  const Placement placed = place(box_around(319.5, 239.5, 50), kAnyCamera, kRowBox, 0.7);
  EXPECT_NEAR(placed.palm_center.z(), 0.7, 1e-6);
  EXPECT_NEAR(placed.palm_center.head<2>().norm(), 0, 1e-6);
  EXPECT_LT(angle_between(placed.camera_from_row_camera, Eigen::Matrix3d::Identity()), 1e-6);
}

TEST(Placement, AHalfAsLargeBoxIsTwiceAsFarAway) {
  EXPECT_NEAR(place(box_around(319.5, 239.5, 25), kAnyCamera, kRowBox, 0.7).palm_center.z(), 1.4,
              1e-6);
}

TEST(Placement, ABoxOffTheAxisTurnsTheRowByTheAngleOfItsRay) {
  const Placement placed = place(box_around(319.5 + 254, 239.5, 50), kAnyCamera, kRowBox, 0.7);
  EXPECT_NEAR(degrees(angle_between(placed.camera_from_row_camera, Eigen::Matrix3d::Identity())),
              degrees(std::atan(254.0 / 500)), 0.01);
  // The row's optical axis now points at the palm.
  const Eigen::Vector3d axis = placed.camera_from_row_camera.col(2);
  EXPECT_LT((axis - placed.palm_center.normalized()).norm(), 1e-9);
  EXPECT_GT(placed.palm_center.x(), 0);
}

TEST(Placement, ARowBesideItsAxisTurnsToTheMiddleOfTheBox) {
  const BoxTangents aside{.x = 0.1F, .y = -0.1F, .width = 0.2F, .height = 0.4F};
  for (const double half : {25.0, 50.0}) {  // however far away
    const Placement placed = place(box_around(400.5, 100.5, half), kAnyCamera, aside, 0.7);
    const Eigen::Vector3d ray = placed.camera_from_row_camera * Eigen::Vector3d(0.2, 0.1, 1);
    EXPECT_LT((ray.normalized() - kAnyCamera.ray(400.5, 100.5).normalized()).norm(), 1e-6);
  }
}

// A ball of 70 mm 0.7 m away: in the row it fills 0.1 x 0.1; off the axis the flat picture enlarges
// it.
TEST(Placement, ABallOffTheAxisIsAsFarAwayAsItIs) {
  const BoxTangents ball{.x = -0.05F, .y = -0.05F, .width = 0.1F, .height = 0.1F};
  const Eigen::Vector3d center = Eigen::Vector3d(0.45, 0.2, 1).normalized() * 0.7;
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (int i = 0; i < 20000; ++i) {  // points of the sphere's surface
    const double z = -1 + 2 * (i + 0.5) / 20000, turn = 2.399963 * i;
    const double r = std::sqrt(1 - z * z);
    const Eigen::Vector2d p = kAnyCamera.project(
        center + 0.035 * Eigen::Vector3d(r * std::cos(turn), r * std::sin(turn), z));
    left = std::min(left, p.x());
    right = std::max(right, p.x());
    top = std::min(top, p.y());
    bottom = std::max(bottom, p.y());
  }
  const Box box{static_cast<int>(std::lround(left)), static_cast<int>(std::lround(top)),
                static_cast<int>(std::lround(right - left)),
                static_cast<int>(std::lround(bottom - top))};
  const Placement placed = place(box, kAnyCamera, ball, 0.7);
  EXPECT_NEAR(placed.palm_center.norm(), 0.7, 0.02);
  EXPECT_LT((placed.palm_center - center).norm(), 0.03);
}

TEST(Placement, ThePalmLiesBesideTheBoxCenterAsItDoesInTheRow) {
  // In the row the box reaches from the palm centre to its right only.
  const BoxTangents right{.x = 0, .y = -0.1F, .width = 0.2F, .height = 0.2F};
  const Placement placed = place(box_around(319.5, 239.5, 50), kAnyCamera, right, 0.7);
  EXPECT_NEAR(placed.palm_center.x() / placed.palm_center.z(), -0.1, 1e-6);
}

}  // namespace
}  // namespace graspdb
