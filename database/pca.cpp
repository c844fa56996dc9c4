// SPDX-License-Identifier: MIT
#include "pca.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using Bytes = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXf as_rows(const DescriptorTable& table) {
  return Eigen::Map<const Bytes>(table.bytes.data(), static_cast<Eigen::Index>(table.rows()),
                                 static_cast<Eigen::Index>(table.size))
      .cast<float>();
}

Eigen::MatrixXf spread_sample(const DescriptorTable& all, std::size_t count) {
  Eigen::MatrixXf sample(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(all.size));
  for (std::size_t i = 0; i < count; ++i) {
    sample.row(static_cast<Eigen::Index>(i)) = as_rows({all.row(i * all.rows() / count), all.size});
  }
  return sample;
}

}  // namespace

Pca fit_pca(const DescriptorTable& all, int dimensions, std::size_t sample) {
  const auto size = static_cast<Eigen::Index>(all.size);
  GRASPDB_CHECK(!all.bytes.empty() && dimensions >= 1 && dimensions <= size);
  Eigen::MatrixXf rows = spread_sample(all, std::min(sample, all.rows()));
  Pca pca;
  pca.mean = rows.colwise().mean();
  rows.rowwise() -= pca.mean;
  Eigen::MatrixXf covariance = Eigen::MatrixXf::Zero(size, size);
  covariance.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(covariance);
  pca.directions = solver.eigenvectors().rightCols(dimensions).rowwise().reverse();
  const float largest = std::max(solver.eigenvalues()(size - 1), 0.0F);
  pca.deviation = std::sqrt(largest / static_cast<float>(rows.rows()));
  return pca;
}

Eigen::MatrixXf project(const Pca& pca, const DescriptorTable& descriptors) {
  return (as_rows(descriptors).rowwise() - pca.mean) * pca.directions;
}

}  // namespace graspdb
