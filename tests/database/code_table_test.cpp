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

// Every fifth stretch of 16 rows near to `to`: the others are far away by their first numbers
// alone, or by their last ones alone. Of the near ones some are there again later.
std::vector<Code> codes_around(const Code& to, std::size_t rows, RandomStream& random) {
  std::vector<Code> codes;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t stretch = row / 16 % 5;
    codes.push_back(random_code(to.size(), random));
    if (stretch == 1 && row >= 1000) codes[row] = codes[row - 976];
    if (stretch == 2) std::copy_n(to.begin(), to.size() / 2, codes[row].begin());
    if (stretch != 0) continue;
    std::ranges::transform(codes[row], to, codes[row].begin(),
                           [](std::int8_t noise, std::int8_t at) {
                             return static_cast<std::int8_t>(std::clamp(at + noise / 8, -128, 127));
                           });
  }
  return codes;
}

CodeTable table_of(const std::vector<Code>& codes, std::size_t dimensions) {
  CodeTable table(codes.size(), dimensions);
  for (std::size_t row = 0; row < codes.size(); ++row) table.store(row, codes[row]);
  return table;
}

TEST(CodeTable, FindsTheNearestOfAPlainLoop) {
  RandomStream random(0);
  for (const std::size_t dimensions : {1, 5, 7, 63, 64, 65, 66, 128, 510}) {
    for (const std::size_t rows : {0, 1, 511, 512, 513, 2000}) {
      const Code query = random_code(dimensions, random);
      const std::vector<Code> codes = codes_around(query, rows, random);
      const CodeTable table = table_of(codes, dimensions);
      const Code other = random_code(dimensions, random);
      const auto found = table.nearest({query, other}, 20);
      ASSERT_EQ(found.size(), 2u);
      EXPECT_EQ(found[0], by_a_plain_loop(codes, query, 20)) << dimensions << ' ' << rows;
      EXPECT_EQ(found[1], by_a_plain_loop(codes, other, 20)) << dimensions << ' ' << rows;
    }
  }
}

// How near the wanted rows are is guessed from every 32nd stretch of 16.
TEST(CodeTable, FindsTheNearestWhereNearRowsAreCommonerOrRarerInTheSample) {
  constexpr std::size_t kDimensions = 32;
  for (const bool commoner : {true, false}) {
    RandomStream random(1);
    const Code query = random_code(kDimensions, random);
    std::vector<Code> codes;
    for (std::size_t row = 0; row < 4000; ++row) {
      codes.push_back(random_code(kDimensions, random));
      const bool sampled = row / 16 % 32 == 0;
      if (sampled == commoner) std::copy_n(query.begin(), kDimensions / 2, codes.back().begin());
    }
    const CodeTable table = table_of(codes, kDimensions);
    EXPECT_EQ(table.nearest({query}, 400).front(), by_a_plain_loop(codes, query, 400)) << commoner;
  }
}

}  // namespace
}  // namespace graspdb
