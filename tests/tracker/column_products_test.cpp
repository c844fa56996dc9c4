// SPDX-License-Identifier: MIT
#include "column_products.h"

#include <gtest/gtest.h>

#include <vector>

#include "graspdb/core/random.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

class EachInstructionSetSums : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(ColumnProducts, EachInstructionSetSums, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(EachInstructionSetSums, WhatAPlainLoopSums) {
  use_param();
  RandomStream random(1);
  for (const std::size_t columns : {kColumnBlock, 4 * kColumnBlock}) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{77}}) {
      std::vector<float> lines(count * columns), products(columns * columns, 1.5F);
      for (float& number : lines) number = static_cast<float>(random.normal());
      column_products(lines, columns, products);
      for (std::size_t row = 0; row < columns; ++row) {
        for (std::size_t column = 0; column <= row; ++column) {
          float sum = 0;
          for (std::size_t k = 0; k < count; ++k)
            sum += lines[k * columns + row] * lines[k * columns + column];
          EXPECT_EQ(products[row * columns + column], sum);
        }
      }
    }
  }
  use_best();
}

}  // namespace
}  // namespace graspdb
