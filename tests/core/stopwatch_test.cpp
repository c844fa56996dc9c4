// SPDX-License-Identifier: MIT
#include "graspdb/core/stopwatch.h"

#include <gtest/gtest.h>

#include <thread>

namespace graspdb {
namespace {

TEST(Stopwatch, TellsMillisecondsAndRunsOn) {
  const Stopwatch outer;
  const Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const double first = watch.ms();
  EXPECT_GE(first, 5);
  EXPECT_GE(watch.ms(), first);
  EXPECT_LE(first, outer.ms());
}

TEST(Stopwatch, ALapEndsWhereTheNextBegins) {
  const Stopwatch outer;
  Stopwatch watch;
  const Stopwatch inner;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const double first = watch.lap_ms();
  EXPECT_GE(first, 5);
  const double both = first + watch.lap_ms();
  EXPECT_GE(both, first);
  EXPECT_LE(both, outer.ms());
  EXPECT_LE(watch.ms(), inner.ms() - 5);
}

}  // namespace
}  // namespace graspdb
