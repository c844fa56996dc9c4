// SPDX-License-Identifier: MIT
#include "least_squares.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

namespace graspdb {
namespace {

TEST(LeastSquares, SolvesALinearProblemLikeTheNormalEquations) {
  Eigen::MatrixXd a(4, 2);
  a << 1, 2, 3, 4, 5, 7, 1, 0;
  const Eigen::Vector4d b(1, -2, 3, 4);
  const Minimum found =
      minimise([&](const Eigen::VectorXd& x) { return Eigen::VectorXd(a * x - b); },
               Eigen::Vector2d(10, -10), 50);
  const Eigen::Vector2d expected = (a.transpose() * a).ldlt().solve(a.transpose() * b);
  EXPECT_TRUE(found.x.isApprox(expected, 1e-3));
  EXPECT_NEAR(found.cost, (a * expected - b).squaredNorm() / 2, 1e-4);
}

TEST(LeastSquares, FollowsACurvedValley) {
  const Residuals rosenbrock = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]));
  };
  EXPECT_TRUE(
      minimise(rosenbrock, Eigen::Vector2d(-1.2, 1), 200).x.isApprox(Eigen::Vector2d(1, 1), 1e-3));
}

TEST(LeastSquares, StopsAtAHinge) {
  const Residuals hinge = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::Vector2d(x[0] + 1, 100 * std::max(0.0, 2 - x[0])));
  };
  EXPECT_NEAR(minimise(hinge, Eigen::VectorXd::Constant(1, 9), 100).x[0], 2, 2e-3);
}

TEST(LeastSquares, NeverEndsAboveItsStart) {
  const Residuals kinked = [](const Eigen::VectorXd& x) {
    return Eigen::VectorXd(Eigen::Vector2d(std::abs(x[0]), std::abs(x[0] - x[1]) + 0.5));
  };
  const Eigen::Vector2d start(3, -4);
  EXPECT_LT(minimise(kinked, start, 30).cost, kinked(start).squaredNorm() / 2);
}

}  // namespace
}  // namespace graspdb
