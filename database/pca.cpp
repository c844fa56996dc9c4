// SPDX-License-Identifier: MIT
#include "pca.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using Bytes = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, kDescriptorSize, Eigen::RowMajor>;

Eigen::MatrixXf as_rows(const std::uint8_t* descriptors, std::size_t count) {
  return Eigen::Map<const Bytes>(descriptors, static_cast<Eigen::Index>(count), kDescriptorSize)
      .cast<float>();
}

Eigen::MatrixXf spread_sample(std::span<const std::uint8_t> hogs, std::size_t count) {
  const std::size_t rows = hogs.size() / kDescriptorSize;
  Eigen::MatrixXf sample(static_cast<Eigen::Index>(count), kDescriptorSize);
  for (std::size_t i = 0; i < count; ++i) {
    sample.row(static_cast<Eigen::Index>(i)) =
        as_rows(hogs.data() + i * rows / count * kDescriptorSize, 1);
  }
  return sample;
}

}  // namespace

Pca fit_pca(std::span<const std::uint8_t> hogs, int dimensions, std::size_t sample) {
  GRASPDB_CHECK(!hogs.empty() && dimensions >= 1 && dimensions <= kDescriptorSize);
  Eigen::MatrixXf rows = spread_sample(hogs, std::min(sample, hogs.size() / kDescriptorSize));
  Pca pca;
  pca.mean = rows.colwise().mean();
  rows.rowwise() -= pca.mean;
  Eigen::MatrixXf covariance = Eigen::MatrixXf::Zero(kDescriptorSize, kDescriptorSize);
  covariance.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> solver(covariance);
  pca.directions = solver.eigenvectors().rightCols(dimensions).rowwise().reverse();
  const float largest = std::max(solver.eigenvalues()(kDescriptorSize - 1), 0.0F);
  pca.deviation = std::sqrt(largest / static_cast<float>(rows.rows()));
  return pca;
}

Eigen::MatrixXf project(const Pca& pca, const std::uint8_t* descriptors, std::size_t count) {
  return (as_rows(descriptors, count).rowwise() - pca.mean) * pca.directions;
}

}  // namespace graspdb
