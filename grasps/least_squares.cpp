// SPDX-License-Identifier: MIT
#include "least_squares.h"

#include <Eigen/Cholesky>

namespace graspdb {
namespace {

Eigen::MatrixXd jacobian(const Residuals& residuals, const Eigen::VectorXd& x,
                         const Eigen::VectorXd& at_x, double step) {
  Eigen::MatrixXd j(at_x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd moved = x;
    moved[i] += step;
    j.col(i) = (residuals(moved) - at_x) / step;
  }
  return j;
}

}  // namespace

Minimum minimise(const Residuals& residuals, Eigen::VectorXd x, int iterations, double step) {
  constexpr double kGiveUpDamping = 1e8;
  Eigen::VectorXd r = residuals(x);
  double damping = 1e-2;
  for (int i = 0; i < iterations; ++i) {
    const Eigen::MatrixXd j = jacobian(residuals, x, r, step);
    const Eigen::MatrixXd normal = j.transpose() * j;
    const Eigen::VectorXd gradient = j.transpose() * r;
    const double before = r.squaredNorm();
    bool lowered = false;
    while (!lowered && damping < kGiveUpDamping) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + 1e-9).matrix();
      const Eigen::VectorXd candidate = x - damped.ldlt().solve(gradient);
      Eigen::VectorXd r_candidate = residuals(candidate);
      lowered = r_candidate.squaredNorm() < before;
      damping *= lowered ? 0.3 : 4.0;
      if (lowered) {
        x = candidate;
        r = std::move(r_candidate);
      }
    }
    if (!lowered || before - r.squaredNorm() < 1e-6 * before) break;
  }
  return {x, r.squaredNorm() / 2};
}

}  // namespace graspdb
