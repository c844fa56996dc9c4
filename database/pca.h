// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "graspdb/core/descriptor.h"

namespace graspdb {

// The directions in which a set of descriptors varies most.
struct Pca {
  Eigen::RowVectorXf mean;
  Eigen::MatrixXf directions;  // a column each, of unit length, the widest first
  float deviation = 0;         // the standard deviation along the first
};

// Fits to rows spread evenly over `all` (at least one; at most `sample` are looked at).
// Deterministic.
Pca fit_pca(const DescriptorTable& all, int dimensions, std::size_t sample);

// Where descriptors lie along the directions: a row each.
Eigen::MatrixXf project(const Pca& pca, const DescriptorTable& descriptors);

}  // namespace graspdb
