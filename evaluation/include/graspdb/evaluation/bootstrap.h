// SPDX-License-Identifier: MIT
// Confidence intervals over sequences, not frames: frames of one sequence are no independent
// witnesses.
#pragma once

#include <cstdint>
#include <vector>

namespace graspdb {

struct Interval {
  double mean = 0;
  double low = 0, high = 0;   // 95 %
  std::size_t sequences = 0;  // that have a value
};

constexpr int kBootstrapDraws = 10000;

// The percentile bootstrap (Efron 1979) of the mean: as many values are drawn with replacement as
// there are, `kBootstrapDraws` times. NaN values are left out. No value gives NaN; one value is its
// own mean and says nothing of how far off it may be: low and high are NaN. A pure function of its
// arguments.
Interval bootstrap_mean(const std::vector<double>& per_sequence, std::uint64_t seed);

// Of a - b, sequence by sequence: the values of one sequence stand at one place in both.
Interval bootstrap_difference(const std::vector<double>& a, const std::vector<double>& b,
                              std::uint64_t seed);

}  // namespace graspdb
