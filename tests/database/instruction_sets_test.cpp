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
  for (const std::size_t pairs : {1, 2, 3, 64}) {
    constexpr std::size_t kBlocks = 3;
    std::vector<std::int8_t> query(2 * pairs), codes(kBlocks * kCodeBlock * 2 * pairs);
    const auto fill = [&](std::vector<std::int8_t>& code) {
      for (std::int8_t& value : code) {
        value = static_cast<std::int8_t>(static_cast<int>(random.below(255)) - 127);
      }
    };
    fill(query);
    fill(codes);
    std::vector<std::int32_t> norms(kBlocks * kCodeBlock), expected(norms.size()),
        squared(norms.size()), packed;
    for (std::size_t i = 0; i < pairs; ++i) {
      packed.push_back(code_pair(query[2 * i], query[2 * i + 1]));
    }
    std::int32_t query_norm = 0;
    for (const std::int8_t value : query) query_norm += value * value;
    for (std::size_t row = 0; row < norms.size(); ++row) {
      for (std::size_t i = 0; i < 2 * pairs; ++i) {
        const std::size_t block = row / kCodeBlock * kCodeBlock * 2 * pairs;
        const std::int8_t value =
            codes[block + i / 2 * 2 * kCodeBlock + row % kCodeBlock * 2 + i % 2];
        norms[row] += value * value;
        expected[row] += (value - query[i]) * (value - query[i]);
      }
    }
    const std::int32_t bound = expected[20];
    std::array<bool, kBlocks> near;
    code_distances(packed, query_norm, codes.data(), norms.data(), bound, squared, near);
    EXPECT_EQ(squared, expected);
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const auto rows = std::span(expected).subspan(block * kCodeBlock, kCodeBlock);
      EXPECT_EQ(near[block], std::ranges::any_of(rows, [&](int d) { return d < bound; }));
    }
  }
}

}  // namespace
}  // namespace graspdb
