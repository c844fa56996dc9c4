// SPDX-License-Identifier: MIT
// A file of version 1 opens in every later release. The golden file is never made again: a change
// of the writer that alters its bytes is a new version, with a golden file of its own.
#include <gtest/gtest.h>

#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

const std::filesystem::path kGolden =
    std::filesystem::path(GRASPDB_SOURCE_DIR) / "tests/database/golden/v1.graspdb";

TEST(GoldenDatabase, OpensAndVerifies) {
  EXPECT_NO_THROW(verify_database(kGolden));
  const Database database = Database::open(kGolden);
  ASSERT_EQ(database.rows(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::ranges::equal(database.hog(i), testing::toy_row(i).hog));
    EXPECT_TRUE(std::ranges::equal(database.label(i), testing::toy_row(i).label));
  }
  EXPECT_EQ(database.info().hands.at(0).name, "toy");
}

TEST(GoldenDatabase, IsWhatTheWriterWrites) {
  const testing::TemporaryDirectory directory;
  write_database(directory / "again.graspdb", testing::toy_info(), testing::toy_rows(3));
  EXPECT_EQ(read_text(directory / "again.graspdb"), read_text(kGolden));
}

}  // namespace
}  // namespace graspdb
