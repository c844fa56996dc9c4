// SPDX-License-Identifier: MIT
#include "cells.h"

#include <gtest/gtest.h>

#include "graspdb/core/random.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

Cells drawn_cells(RandomStream& random) {
  Cells cells;
  for (std::uint64_t& row : cells) row = random.bits() & random.bits();
  return cells;
}

bool has(const Cells& cells, int x, int y) {
  return x >= 0 && x < kSide && y >= 0 && y < kSide && (cells[y] >> x & 1) != 0;
}

class EachInstructionSetCounts : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(Cells, EachInstructionSetCounts, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(EachInstructionSetCounts, CellsAsOneByOne) {
  use_param();
  RandomStream random(1);
  const Cells seen = drawn_cells(random), inside = drawn_cells(random), hand = drawn_cells(random),
              arm = drawn_cells(random);
  for (const int right : {0, 1, -5, 13, kSide - 1, 1 - kSide}) {
    for (const int down : {0, -1, 7, -13, kSide - 1, 1 - kSide}) {
      Overlap wanted;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const bool is_hand = has(hand, x - right, y - down), is_seen = has(seen, x, y);
          const bool is_arm = has(arm, x - right, y - down);
          if (is_seen && !is_hand) ++(is_arm ? wanted.of_arm : wanted.bare);
          if (is_hand && !is_seen && has(inside, x, y)) ++wanted.in_vain;
        }
      }
      const Overlap overlap =
          overlap_of(seen, inside, MovableCells(hand), MovableCells(arm), right, down);
      EXPECT_EQ(overlap.bare, wanted.bare);
      EXPECT_EQ(overlap.of_arm, wanted.of_arm);
      EXPECT_EQ(overlap.in_vain, wanted.in_vain);
    }
  }
  use_best();
}

}  // namespace
}  // namespace graspdb
