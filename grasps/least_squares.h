// SPDX-License-Identifier: MIT
// Small dense non-linear least squares.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace graspdb {

using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

struct Minimum {
  Eigen::VectorXd x;
  double cost = 0;  // half the sum of squared residuals
};

// Levenberg-Marquardt with Marquardt's scaling and forward differences of `step`; deterministic.
// The residuals may have kinks (hinges, nearest points): a step that does not lower the cost is not
// taken. Ends after `iterations`, or when no step lowers the cost by more than 1e-6 of it.
Minimum minimise(const Residuals& residuals, Eigen::VectorXd x, int iterations, double step = 1e-5);

}  // namespace graspdb
