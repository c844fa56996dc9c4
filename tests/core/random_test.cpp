// SPDX-License-Identifier: MIT
#include "graspdb/core/random.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "graspdb/core/parallel.h"

namespace graspdb {
namespace {

TEST(Random, TheSameSeedAndStreamGiveTheSameNumbers) {
  RandomStream a(7, 3), b(7, 3), other(7, 4);
  const auto first = a.bits();
  EXPECT_EQ(first, b.bits());
  EXPECT_NE(first, other.bits());
}

TEST(Random, ASkippedNumberIsTheOneThatWouldHaveCome) {
  RandomStream a(7, 3), b(7, 3);
  a.bits();
  b.skip();
  EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, MomentsAreThoseOfTheDistributions) {
  RandomStream random(0);
  const int n = 200000;
  double sum = 0, squares = 0, uniform = 0;
  for (int i = 0; i < n; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
    uniform += random.uniform();
  }
  EXPECT_NEAR(sum / n, 0, 0.01);
  EXPECT_NEAR(squares / n, 1, 0.02);
  EXPECT_NEAR(uniform / n, 0.5, 0.005);
}

TEST(Random, BelowStaysBelowAndReachesEveryValue) {
  RandomStream random(5);
  std::vector<int> seen(7);
  for (int i = 0; i < 1000; ++i) ++seen.at(random.below(7));
  for (int count : seen) EXPECT_GT(count, 90);
}

TEST(Parallel, EveryIndexIsVisitedOnce) {
  std::vector<std::atomic<int>> visits(1000);
  parallel_for(visits.size(), 3, [&](std::size_t i) { ++visits[i]; });
  for (const auto& count : visits) EXPECT_EQ(count, 1);
}

TEST(Parallel, AnExceptionReachesTheCaller) {
  EXPECT_THROW(parallel_for(100, 2,
                            [](std::size_t i) {
                              if (i == 40) throw std::runtime_error("x");
                            }),
               std::runtime_error);
}

}  // namespace
}  // namespace graspdb
