// SPDX-License-Identifier: MIT
#include "crossing.h"

#include <gtest/gtest.h>

namespace graspdb {
namespace {

TEST(PassesThrough, AWayThatLeavesACardAtItsOtherSide) {
  const auto card = make_box({0.085, 0.054, 0.001});
  EXPECT_TRUE(passes_through(*card, {0, 0, -0.004}, {0.002, 0, 0.001}));
  EXPECT_TRUE(passes_through(*card, {0.04, 0, 0.02}, {0.04, 0, -0.0006}));
  EXPECT_FALSE(passes_through(*card, {0, 0, 0.02}, {0, 0, 0.0006}));         // before it
  EXPECT_FALSE(passes_through(*card, {0, 0, 0.02}, {0, 0, -0.0004}));        // in it
  EXPECT_FALSE(passes_through(*card, {0.05, 0, 0.004}, {0.05, 0, -0.004}));  // beside it
}

TEST(PassesThrough, NotAWayThatCutsACorner) {
  const auto box = make_box({0.04, 0.04, 0.04});
  EXPECT_FALSE(passes_through(*box, {0.019, 0, 0.022}, {0.022, 0, 0.019}));
  EXPECT_FALSE(passes_through(*make_cylinder(0.04, 0.1), {0.0205, 0, 0}, {0.0145, 0.0145, 0}));
  EXPECT_TRUE(passes_through(*box, {0, 0, 0.022}, {0, 0, -0.022}));
}

}  // namespace
}  // namespace graspdb
