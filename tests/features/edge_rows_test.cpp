// SPDX-License-Identifier: MIT
// Every instruction set that this processor has finds the same edges.
#include "edge_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/core/random.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

// Noise with an empty half, so that some gradients are zero.
EdgeCanvas noise(std::uint64_t seed) {
  RandomStream random(seed);
  EdgeCanvas canvas{};
  for (std::size_t i = 0; i < canvas.size() / 2; ++i) {
    canvas[i] = static_cast<float>(random.below(1000)) / 1000;
  }
  return canvas;
}

EdgeRow edges_of(const EdgeCanvas& coverage, const EdgeCanvas& brightness, std::size_t y) {
  EdgeRow edges;
  find_edges(coverage, brightness, y, edges);
  return edges;
}

class EdgeRows : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(Each, EdgeRows, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(EdgeRows, AreTheSame) {
  EdgeCanvas coverage = noise(1);
  for (float& value : coverage) value = std::sqrt(value);  // so that some pixels are well inside
  const EdgeCanvas brightness = noise(2);
  int inner_edges = 0;
  for (std::size_t y = 0; y < kEdgeSide; ++y) {
    use_param();
    const EdgeRow here = edges_of(coverage, brightness, y);
    use_best();
    const EdgeRow best = edges_of(coverage, brightness, y);
    EXPECT_EQ(here.outline_weight, best.outline_weight);
    EXPECT_EQ(here.inner_weight, best.inner_weight);
    for (std::size_t x = 0; x < kEdgeSide; ++x) {
      if (best.outline_weight[x] > 0) {
        EXPECT_EQ(here.outline_bin[x], best.outline_bin[x]);
      }
      if (best.inner_weight[x] > 0) {
        EXPECT_EQ(here.inner_bin[x], best.inner_bin[x]);
        ++inner_edges;
      }
    }
  }
  EXPECT_GT(inner_edges, 30);
}

TEST(EdgeRow, PointsAcrossTheEdge) {
  constexpr double kBin = 3.14159265358979 / 8;
  for (int tenth = 1; tenth < 80; tenth += 3) {
    const double angle = kBin * tenth / 10;
    EdgeCanvas ramp;
    for (std::size_t i = 0; i < ramp.size(); ++i) {
      const double x = static_cast<double>(i % kEdgeStride),
                   y = static_cast<double>(i / kEdgeStride);
      ramp[i] = static_cast<float>((x * std::cos(angle) + y * std::sin(angle)) / 8);
    }
    const EdgeRow edges = edges_of(ramp, EdgeCanvas{}, 5);
    EXPECT_NEAR(edges.outline_bin[9], tenth / 10.0, 0.02);
    EXPECT_NEAR(edges.outline_weight[9], 1.0 / 8, 1e-5);
    EXPECT_EQ(edges.inner_weight[9], 0);
  }
}

}  // namespace
}  // namespace graspdb
