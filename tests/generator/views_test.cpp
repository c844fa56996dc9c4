// SPDX-License-Identifier: MIT
#include "graspdb/views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "graspdb/random.h"
#include "graspdb/transform.h"

namespace graspdb {
namespace {

double mean_distance_to_nearest_deg(int count) {
  const std::vector<Eigen::Matrix3d> views = view_rotations(count);
  RandomStream random(4);
  constexpr int kSamples = 500;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::Matrix3d r =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    double nearest = kPi;
    for (const Eigen::Matrix3d& view : views) nearest = std::min(nearest, angle_between(view, r));
    sum += nearest;
  }
  return degrees(sum) / kSamples;
}

TEST(Views, AreRotations) {
  for (const Eigen::Matrix3d& view : view_rotations(648)) {
    EXPECT_LT((view * view.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(view.determinant(), 1, 1e-12);
  }
}

TEST(Views, TheNearestOf648Is13DegreesAway) {
  EXPECT_NEAR(mean_distance_to_nearest_deg(648), 13.6, 0.3);
}

TEST(Views, AnyNumberCoversAllRotations) {
  EXPECT_EQ(view_rotations(1).size(), 1u);
  EXPECT_NEAR(mean_distance_to_nearest_deg(1296), 10.9, 0.3);
}

}  // namespace
}  // namespace graspdb
