// SPDX-License-Identifier: MIT
#include "successors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/tracker/pose_vector.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

constexpr std::uint32_t kViews = 72, kSteps = 3, kGrasps = 2;

// Turned any way, the same views for every pose.
Database grid(const testing::TemporaryDirectory& directory, std::size_t rows) {
  DatabaseInfo info = testing::toy_info();
  info.views = kViews;
  info.steps = kSteps;
  info.variants = {"held"};
  std::vector<Row> table(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t view = i % kViews;
    table[i] = testing::toy_row(view);
    table[i].view = static_cast<std::uint32_t>(view);
    table[i].step = static_cast<std::uint8_t>(1 + i / kViews % kSteps);
    table[i].grasp = i / (kViews * kSteps) % 2 == 0 ? 1 : 9;
    table[i].variant = 0;
  }
  write_database(directory / "grid.graspdb", info, table);
  return Database::open(directory / "grid.graspdb");
}

// By sorting all views by their angle.
std::set<std::uint32_t> nearest_views(const Database& database, std::uint32_t view) {
  std::vector<std::pair<double, std::uint32_t>> all;
  for (std::uint32_t other = 0; other < kViews; ++other)
    all.emplace_back(angle_between(unpack_label(database.label(view)).rotation,
                                   unpack_label(database.label(other)).rotation),
                     other);
  std::sort(all.begin(), all.end());
  std::set<std::uint32_t> nearest;
  for (std::size_t i = 0; i < 16; ++i) nearest.insert(all[i].second);
  return nearest;
}

TEST(Successors, AreTheSixteenNearestViewsAtTheNextStepsOfTheSameGrasp) {
  const testing::TemporaryDirectory directory;
  const Database database = grid(directory, kViews * kSteps * kGrasps);
  const Successors successors(database);
  for (std::uint32_t row = 0; row < database.rows(); ++row) {
    std::set<std::uint32_t> expected;
    const std::set<std::uint32_t> views = nearest_views(database, row % kViews);
    for (std::uint32_t other = 0; other < database.rows(); ++other) {
      const int steps = int{database.step(other)} - int{database.step(row)};
      if (database.grasp(other) == database.grasp(row) && std::abs(steps) <= 1 &&
          views.contains(other % kViews))
        expected.insert(other);
    }
    std::vector<std::uint32_t> found;
    successors.append(row, found);
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::set(found.begin(), found.end()), expected);
    EXPECT_TRUE(expected.contains(row));
  }
}

TEST(Successors, RefuseADatabaseThatIsNoGrid) {
  const testing::TemporaryDirectory directory;
  const Database database = grid(directory, kViews * kSteps * kGrasps - 1);
  EXPECT_THROW(Successors{database}, Error);
}

}  // namespace
}  // namespace graspdb
