// SPDX-License-Identifier: MIT
#include "code_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

using Code = std::vector<std::int8_t>;

// The largest numbers more often than others: sums must hold them, too.
Code random_code(std::size_t dimensions, RandomStream& random) {
  Code code(dimensions);
  for (std::int8_t& number : code) {
    const std::uint64_t byte = random.below(3) == 0 ? random.below(2) * 255 : random.below(256);
    number = static_cast<std::int8_t>(static_cast<int>(byte) - 128);
  }
  return code;
}

std::vector<Neighbor> by_a_plain_loop(const std::vector<Code>& codes, const Code& query,
                                      std::size_t count) {
  std::vector<Neighbor> all;
  for (const Code& code : codes) {
    std::uint32_t squared = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
      const int difference = code[i] - query[i];
      squared += static_cast<std::uint32_t>(difference * difference);
    }
    all.push_back({static_cast<std::uint32_t>(all.size()), squared});
  }
  std::ranges::stable_sort(all, {}, &Neighbor::squared_distance);
  all.resize(std::min(count, all.size()));
  return all;
}

TEST(CodeTable, FindsTheNearestOfAPlainLoop) {
  RandomStream random(0);
  for (const std::size_t dimensions : {1, 5, 7, 64, 128, 510}) {
    for (const std::size_t rows : {0, 1, 511, 512, 513}) {
      std::vector<Code> codes;
      CodeTable table(rows, dimensions);
      for (std::size_t row = 0; row < rows; ++row) {
        codes.push_back(random_code(dimensions, random));
        table.store(row, codes.back());
      }
      const Code query = random_code(dimensions, random);
      const std::vector<Neighbor> found = table.nearest(query, 20);
      const std::vector<Neighbor> expected = by_a_plain_loop(codes, query, 20);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].row, expected[i].row) << dimensions << ' ' << rows;
        EXPECT_EQ(found[i].squared_distance, expected[i].squared_distance);
      }
    }
  }
}

}  // namespace
}  // namespace graspdb
