// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(Bootstrap, EqualValuesLeaveNoDoubt) {
  const Interval interval = bootstrap_mean({3, 3, 3, 3}, 1);
  EXPECT_EQ(interval.mean, 3);
  EXPECT_EQ(interval.low, 3);
  EXPECT_EQ(interval.high, 3);
  EXPECT_EQ(interval.sequences, 4U);
}

TEST(Bootstrap, OfZerosAndOnesItIsTheBinomialDistribution) {
  // The mean of 40 draws from an even mix: quantiles 2.5 % and 97.5 % of Binomial(40, 1/2) / 40
  // are 14 / 40 and 26 / 40.
  std::vector<double> values(40, 0.0);
  std::fill(values.begin(), values.begin() + 20, 1.0);
  const Interval interval = bootstrap_mean(values, 7);
  EXPECT_EQ(interval.mean, 0.5);
  EXPECT_NEAR(interval.low, 14.0 / 40, 1e-12);
  EXPECT_NEAR(interval.high, 26.0 / 40, 1e-12);
}

TEST(Bootstrap, HoldsTheTrueMeanAboutAsOftenAsItSays) {
  RandomStream random(11);
  int held = 0;
  constexpr int kTrials = 100;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(30);
    for (double& value : values) value = 2 + random.normal();
    const Interval interval = bootstrap_mean(values, 5);
    held += interval.low <= 2 && 2 <= interval.high;
  }
  EXPECT_NEAR(held / double{kTrials}, 0.95, 0.05);
}

TEST(Bootstrap, IsAFunctionOfValuesAndSeed) {
  const std::vector<double> values = {1, 2, 4, 8, 16};
  EXPECT_EQ(bootstrap_mean(values, 3).low, bootstrap_mean(values, 3).low);
  EXPECT_EQ(bootstrap_mean(values, 3).mean, bootstrap_mean(values, 4).mean);
}

TEST(Bootstrap, SequencesWithoutAValueAreLeftOut) {
  const Interval some = bootstrap_mean({kNan, 2, kNan, 4}, 0);
  EXPECT_EQ(some.mean, 3);
  EXPECT_EQ(some.sequences, 2U);
  EXPECT_EQ(some.low, 2);
  EXPECT_EQ(some.high, 4);
  const Interval none = bootstrap_mean({kNan}, 0);
  EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.low) && std::isnan(none.high));
  EXPECT_EQ(none.sequences, 0U);
}

TEST(Bootstrap, OneSequenceSaysNothingOfOthers) {
  const Interval one = bootstrap_mean({7}, 0);
  EXPECT_EQ(one.mean, 7);
  EXPECT_TRUE(std::isnan(one.low) && std::isnan(one.high));
}

TEST(Bootstrap, PairingTakesTheSequencesOwnDifficultyAway) {
  // Hard and easy sequences, on each of which a is better by one.
  std::vector<double> a, b;
  for (int i = 0; i < 20; ++i) {
    b.push_back(10.0 * i);
    a.push_back(10.0 * i - 1);
  }
  const Interval difference = bootstrap_difference(a, b, 2);
  EXPECT_EQ(difference.mean, -1);
  EXPECT_EQ(difference.low, -1);
  EXPECT_EQ(difference.high, -1);
  EXPECT_GT(bootstrap_mean(a, 2).high, bootstrap_mean(b, 2).low);
}

}  // namespace
}  // namespace graspdb
