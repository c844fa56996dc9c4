// SPDX-License-Identifier: MIT
#include "placement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace graspdb {
namespace {

constexpr Intrinsics kCamera{
    .width = 640, .height = 480, .fx = 500, .fy = 500, .cx = 319.5, .cy = 239.5};
constexpr BoxTangents kRowBox{.x = -0.1F, .y = -0.1F, .width = 0.2F, .height = 0.2F};

// The box of whole pixels from (u, v) - half to (u, v) + half.
Box box_around(double u, double v, double half) {
  return {static_cast<int>(std::lround(u - half + 0.5)),
          static_cast<int>(std::lround(v - half + 0.5)), static_cast<int>(std::lround(2 * half)),
          static_cast<int>(std::lround(2 * half))};
}

TEST(Placement, ABoxAsLargeAsTheRowsIsAsFarAway) {
  const Placement placed = place(box_around(319.5, 239.5, 50), kCamera, kRowBox, 0.7);
  EXPECT_NEAR(placed.palm_centre.z(), 0.7, 1e-6);
  EXPECT_NEAR(placed.palm_centre.head<2>().norm(), 0, 1e-6);
  EXPECT_LT(angle_between(placed.camera_from_row_camera, Eigen::Matrix3d::Identity()), 1e-6);
}

TEST(Placement, AHalfAsLargeBoxIsTwiceAsFarAway) {
  EXPECT_NEAR(place(box_around(319.5, 239.5, 25), kCamera, kRowBox, 0.7).palm_centre.z(), 1.4,
              1e-6);
}

TEST(Placement, TwoHundredSeventyPixelsOffAxisTurnByTwentySevenDegreesAtFocal500) {
  const Placement placed = place(box_around(319.5 + 254, 239.5, 50), kCamera, kRowBox, 0.7);
  EXPECT_NEAR(degrees(angle_between(placed.camera_from_row_camera, Eigen::Matrix3d::Identity())),
              degrees(std::atan(254.0 / 500)), 0.01);
  // The row's optical axis now points at the palm.
  const Eigen::Vector3d axis = placed.camera_from_row_camera.col(2);
  EXPECT_LT((axis - placed.palm_centre.normalized()).norm(), 1e-9);
  EXPECT_GT(placed.palm_centre.x(), 0);
}

TEST(Placement, ThePalmLiesBesideTheBoxCentreAsItDoesInTheRow) {
  // In the row the box reaches from the palm centre to its right only.
  const BoxTangents right{.x = 0, .y = -0.1F, .width = 0.2F, .height = 0.2F};
  const Placement placed = place(box_around(319.5, 239.5, 50), kCamera, right, 0.7);
  EXPECT_NEAR(placed.palm_centre.x() / placed.palm_centre.z(), -0.1, 1e-6);
}

}  // namespace
}  // namespace graspdb
