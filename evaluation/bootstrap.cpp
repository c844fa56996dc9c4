// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "nan.h"

namespace graspdb {
namespace {

double drawn_mean(const std::vector<double>& values, RandomStream random) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[static_cast<std::size_t>(random.below(values.size()))];
  }
  return sum / static_cast<double>(values.size());
}

}  // namespace

Interval bootstrap_mean(const std::vector<double>& per_sequence, std::uint64_t seed) {
  std::vector<double> values;
  std::copy_if(per_sequence.begin(), per_sequence.end(), std::back_inserter(values),
               [](double value) { return !std::isnan(value); });
  if (values.empty()) return {kNan, kNan, kNan, 0};
  double sum = 0;
  for (double value : values) sum += value;
  if (values.size() < 2) return {sum, kNan, kNan, values.size()};
  std::vector<double> means(kBootstrapDraws);
  for (std::size_t draw = 0; draw < means.size(); ++draw) {
    means[draw] = drawn_mean(values, RandomStream(seed, draw));
  }
  std::sort(means.begin(), means.end());
  constexpr auto kTail = static_cast<std::size_t>(kBootstrapDraws * 0.025);
  return {sum / static_cast<double>(values.size()), means[kTail], means[means.size() - 1 - kTail],
          values.size()};
}

Interval bootstrap_difference(const std::vector<double>& a, const std::vector<double>& b,
                              std::uint64_t seed) {
  GRASPDB_CHECK(a.size() == b.size());
  std::vector<double> differences(a.size());
  std::transform(a.begin(), a.end(), b.begin(), differences.begin(), std::minus<>());
  return bootstrap_mean(differences, seed);
}

}  // namespace graspdb
