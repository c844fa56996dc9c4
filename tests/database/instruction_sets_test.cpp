// SPDX-License-Identifier: MIT
// Every instruction set that this processor has gives the same distances as plain loops.
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "code_distance.h"
#include "distance.h"
#include "graspdb/core/random.h"

namespace graspdb {
namespace {

class InstructionSets : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(Each, InstructionSets, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(InstructionSets, GiveTheDistancesOfAPlainLoop) {
  constexpr std::size_t kRows = 37;
  RandomStream random(0);
  Descriptor query;
  for (std::uint8_t& value : query) value = random.below(2) ? 255 : 0;
  std::vector<std::uint8_t> rows(kRows * kDescriptorSize + 1);
  for (std::uint8_t& value : rows) value = static_cast<std::uint8_t>(random.below(256));
  const std::uint8_t* unaligned = rows.data() + 1;
  std::vector<std::uint32_t> expected(kRows), squared(kRows), picked(2);
  for (std::size_t i = 0; i < kRows * kDescriptorSize; ++i) {
    const int difference = query[i % kDescriptorSize] - unaligned[i];
    expected[i / kDescriptorSize] += static_cast<std::uint32_t>(difference * difference);
  }
  squared_distances(query, unaligned, squared);
  EXPECT_EQ(squared, expected);
  squared_distances(query, unaligned, std::vector<std::uint32_t>{30, 7}, picked);
  EXPECT_EQ(picked, (std::vector{expected[30], expected[7]}));
}

TEST_P(InstructionSets, GiveTheCodeDistancesOfAPlainLoop) {
  RandomStream random(0);
  for (const std::size_t length : {4, 8, 12, 128}) {
    constexpr std::size_t kBlocks = 3, kRows = kBlocks * kCodeBlock;
    const auto drawn = [&] {
      std::vector<std::int8_t> code(length);
      for (std::int8_t& value : code) value = static_cast<std::int8_t>(random.below(256));
      return code;
    };
    const std::vector<std::int8_t> query = drawn();
    std::vector<std::int8_t> codes(kRows * length);
    std::vector<std::int32_t> terms, expected(kRows), squared(kRows);
    for (std::size_t row = 0; row < kRows; ++row) {
      const std::vector<std::int8_t> code = drawn();
      terms.push_back(row_term(code));
      for (std::size_t i = 0; i < length; ++i) {
        codes[row / kCodeBlock * kCodeBlock * length + i / kCodeQuad * kCodeQuad * kCodeBlock +
              row % kCodeBlock * kCodeQuad + i % kCodeQuad] = code[i];
        expected[row] += (code[i] - query[i]) * (code[i] - query[i]);
      }
    }
    std::vector<std::uint8_t> numbers(length);
    std::ranges::transform(query, numbers.begin(), raised);
    std::int32_t query_norm = 0;
    for (const std::int8_t value : query) query_norm += value * value;
    const std::int32_t bound = expected[20];
    std::array<bool, kBlocks> near;
    code_distances(numbers, query_norm, codes.data(), terms.data(), bound, squared, near);
    EXPECT_EQ(squared, expected);
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const auto rows = std::span(expected).subspan(block * kCodeBlock, kCodeBlock);
      EXPECT_EQ(near[block], std::ranges::any_of(rows, [&](int d) { return d < bound; }));
    }
  }
}

}  // namespace
}  // namespace graspdb
