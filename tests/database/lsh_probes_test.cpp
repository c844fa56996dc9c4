// SPDX-License-Identifier: MIT
#include "lsh_probes.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <set>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

using Cell = std::vector<int>;

// The neighbouring cell that a set of steps leads to.
Cell moved(const ProbeSequence& sequence, std::uint64_t set, std::size_t functions) {
  Cell cell(functions, 0);
  for (std::uint64_t left = set; left != 0; left &= left - 1) {
    const Step& step = sequence.steps()[static_cast<std::size_t>(std::countr_zero(left))];
    EXPECT_EQ(cell[step.function], 0) << "two steps along one function";
    cell[step.function] = step.direction;
  }
  return cell;
}

double score(const Cell& cell, const std::vector<float>& projected) {
  double sum = 0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const double below = projected[i] - std::floor(projected[i]);
    const double wall = cell[i] < 0 ? below : 1 - below;
    if (cell[i] != 0) sum += wall * wall;
  }
  return sum;
}

TEST(ProbeSequence, GivesEveryNeighboringCellOnceNearestFirst) {
  RandomStream random(0);
  for (std::size_t functions = 1; functions <= 6; ++functions) {
    std::vector<float> projected(functions);
    for (float& value : projected) value = static_cast<float>(random.uniform(-9, 9));
    ProbeSequence sequence(projected);
    std::set<Cell> cells;
    double before = 0;
    for (std::uint64_t set = 0; sequence.next(set);) {
      const Cell cell = moved(sequence, set, functions);
      if (cells.empty()) {
        EXPECT_EQ(cell, Cell(functions, 0)) << "the home cell comes first";
      }
      EXPECT_TRUE(cells.insert(cell).second);
      EXPECT_GE(score(cell, projected), before - 1e-5);
      before = score(cell, projected);
    }
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(std::pow(3, functions)));
  }
}

TEST(ProbeSequence, Holds32Functions) {
  ProbeSequence sequence(std::vector<float>(32, 0.25F));
  std::uint64_t set = 0;
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(sequence.next(set));
  EXPECT_THROW(ProbeSequence(std::vector<float>(33, 0.25F)), std::logic_error);
}

}  // namespace
}  // namespace graspdb
