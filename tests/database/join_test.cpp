// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

// The toy database has the rows of variant 0, then those of variant 1.
constexpr std::size_t kRowsAVariant = 80;

class Join : public ::testing::Test {
 protected:
  Join() {
    write_database(directory_ / "whole", toy_info_, rows_);
    for (std::uint8_t variant = 0; variant < 2; ++variant) {
      parts_.push_back({directory_ / std::to_string(variant), 0, variant});
      write_part(variant, part_info(variant));
    }
  }

  DatabaseInfo part_info(std::uint8_t variant) const {
    DatabaseInfo info = toy_info_;
    info.variants = {toy_info_.variants[variant]};
    return info;
  }

  void write_part(std::uint8_t variant, const DatabaseInfo& info) {
    std::vector<Row> rows(rows_.begin() + variant * kRowsAVariant,
                          rows_.begin() + (variant + 1) * kRowsAVariant);
    for (Row& row : rows) row.variant = 0;
    write_database(parts_[variant].file, info, rows);
  }

  // What joining says when the second part's info was changed like this.
  std::string refusal(const std::function<void(DatabaseInfo&)>& change) {
    DatabaseInfo info = part_info(1);
    change(info);
    write_part(1, info);
    try {
      join_databases(directory_ / "joined", toy_info_, parts_);
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(parts_[1].file.string()));
      EXPECT_FALSE(std::filesystem::exists(directory_ / "joined"));
      return error.fault().key;
    }
    return "joined";
  }

  testing::TemporaryDirectory directory_;
  const DatabaseInfo toy_info_ = testing::toy_info();
  const std::vector<Row> rows_ = testing::toy_rows(2 * kRowsAVariant);
  std::vector<DatabasePart> parts_;
};

TEST_F(Join, GivesTheBytesOfTheDatabaseWrittenAtOnce) {
  join_databases(directory_ / "joined", toy_info_, parts_);
  EXPECT_EQ(read_text(directory_ / "joined"), read_text(directory_ / "whole"));
  verify_database(directory_ / "joined");
}

TEST_F(Join, NoPartsAreADatabaseWithoutRows) {
  join_databases(directory_ / "joined", toy_info_, {});
  EXPECT_EQ(Database::open(directory_ / "joined").rows(), 0);
}

TEST_F(Join, RefusesRowsThatDoNotBelong) {
  EXPECT_EQ(refusal([](DatabaseInfo&) {}), "joined");
  std::filesystem::remove(directory_ / "joined");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.processor = "other"; }), "processor");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.hog = "edges"; }), "hog");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.view_rule = "other"; }), "view_rule");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.views = 9; }), "views");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.steps = 6; }), "steps");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.camera_distance = 1; }), "camera_distance_m");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.hands[0].name = "other"; }), "hands");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.hands[0].skeleton.tip_in_distal[0].y() = 1; }),
            "hands");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.variants = {"held"}; }), "variants");
  EXPECT_EQ(refusal([](DatabaseInfo& info) { info.grasps[1].name = "other"; }), "grasps");
}

TEST_F(Join, RefusesAPartThatIsNoDatabase) {
  write_text(parts_[1].file, "not a database");
  EXPECT_THROW(join_databases(directory_ / "joined", toy_info_, parts_), Error);
}

}  // namespace
}  // namespace graspdb
