// SPDX-License-Identifier: MIT
#include "graspdb/generator/views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "graspdb/core/transform.h"
#include "support/nearest_views.h"

namespace graspdb {
namespace {

TEST(Views, AreRotationsAndNoTwoTheSame) {
  for (const int count : {1, 2, 3, 7, 648, 5000}) {
    const std::vector<Eigen::Matrix3d> views = view_rotations(count);
    ASSERT_EQ(views.size(), static_cast<std::size_t>(count));
    double nearest = -1;  // the trace of a rotation by no angle is 3
    for (std::size_t i = 0; i < views.size(); ++i) {
      EXPECT_LT((views[i] * views[i].transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      EXPECT_NEAR(views[i].determinant(), 1, 1e-12);
      for (std::size_t j = 0; j < i; ++j) {
        nearest = std::max(nearest, views[i].cwiseProduct(views[j]).sum());
      }
    }
    const double least_angle = std::acos(std::min((nearest - 1) / 2, 1.0));
    EXPECT_GT(degrees(least_angle), count < 1000 ? 15 : 5) << count;
  }
}

// The figures of docs/views.md.
TEST(Views, TheNearestOf648Is13AndAHalfDegreesAway) {
  const testing::NearestAngles nearest = testing::nearest_angles(view_rotations(648), 100'000);
  EXPECT_NEAR(nearest.mean_deg, 13.53, 0.03);
  EXPECT_NEAR(nearest.p95_deg, 18.9, 0.1);
  EXPECT_LT(nearest.max_deg, 26);
}

TEST(Views, AnyNumberCoversAllRotations) {
  EXPECT_NEAR(testing::nearest_angles(view_rotations(162), 20'000).mean_deg, 21.6, 0.15);
  EXPECT_NEAR(testing::nearest_angles(view_rotations(1000), 20'000).mean_deg, 11.7, 0.1);
  EXPECT_LT(testing::nearest_angles(view_rotations(7), 20'000).max_deg, 150);
}

TEST(Views, RollsOfADirectionLookTheSameWay) {
  const std::vector<Eigen::Matrix3d> views = rolled_directions(3, 13);
  for (const auto& [first, rolls] : {std::pair{0, 4}, {4, 4}, {8, 5}}) {
    const Eigen::RowVector3d along = views[static_cast<std::size_t>(first)].row(2);
    for (int roll = 1; roll < rolls; ++roll) {
      const Eigen::Matrix3d& view = views[static_cast<std::size_t>(first + roll)];
      EXPECT_LT((view.row(2) - along).norm(), 1e-12);
      EXPECT_NEAR(degrees(angle_between(view, views[static_cast<std::size_t>(first + roll - 1)])),
                  360.0 / rolls, 1e-9);
    }
  }
}

}  // namespace
}  // namespace graspdb
