// SPDX-License-Identifier: MIT
#include "merge.h"

#include <gtest/gtest.h>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

constexpr Eigen::Index kLines = 200, kBytes = 64;

// Poses that are linear in their codes, and nothing else.
struct Plane {
  CodeLines codes{kLines, kBytes};
  PoseLine at_zero;
  PoseLines poses;
  LineWeights weights = LineWeights::Constant(kLines, 1.0F / kLines);

  explicit Plane(float spread, float offset) {
    RandomStream random(7);
    const auto draw = [&random](float) { return static_cast<float>(random.normal()); };
    codes = spread * codes.unaryExpr(draw);
    codes.array() += offset;
    Eigen::MatrixXf slopes(kBytes, PoseLine::ColsAtCompileTime);
    slopes = slopes.unaryExpr(draw) / (spread * 8);
    at_zero = at_zero.unaryExpr(draw);
    poses = (codes * slopes).rowwise() + at_zero;
  }
};

TEST(FittedPose, OfALinearMapIsWhatItGivesForTheCode) {
  const Plane plane(1000, 300);  // far more than a code's noise
  const PoseLine mean = plane.weights.transpose() * plane.poses;
  const PoseLine fitted = fitted_pose(plane.poses, plane.codes, plane.weights);
  EXPECT_GT((mean - plane.at_zero).norm(), 0.5);
  EXPECT_LT((fitted - plane.at_zero).norm(), 0.01);
}

TEST(FittedPose, OfCodesThatDifferByNoiseIsTheMean) {
  const Plane plane(0.05F, 0.01F);
  const PoseLine mean = plane.weights.transpose() * plane.poses;
  EXPECT_LT((fitted_pose(plane.poses, plane.codes, plane.weights) - mean).norm(), 0.01);
}

TEST(FittedPose, NeverLeavesWhatTheLinesSpan) {
  const Plane plane(100, 5000);
  const PoseLine fitted = fitted_pose(plane.poses, plane.codes, plane.weights);
  EXPECT_TRUE((fitted.array() >= plane.poses.colwise().minCoeff().array()).all());
  EXPECT_TRUE((fitted.array() <= plane.poses.colwise().maxCoeff().array()).all());
}

TEST(FittedPose, LinesWithoutWeightSayNothing) {
  Plane plane(1000, 300);
  for (Eigen::Index i = 0; i < kLines; i += 2) {
    plane.poses.row(i).setConstant(50);
    plane.weights[i] = 0;
  }
  plane.weights /= plane.weights.sum();
  const PoseLine fitted = fitted_pose(plane.poses, plane.codes, plane.weights);
  EXPECT_LT((fitted - plane.at_zero).norm(), 0.02);
}

TEST(FittedPose, OneLineIsItsPose) {
  const Plane plane(1000, 300);
  const PoseLines one = plane.poses.row(3);
  EXPECT_EQ(fitted_pose(one, plane.codes.row(3), LineWeights::Ones(1)), PoseLine(one));
}

}  // namespace
}  // namespace graspdb
