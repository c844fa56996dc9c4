// SPDX-License-Identifier: MIT
#include "graspdb/database/database.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

using testing::TemporaryDirectory;
using testing::toy_info;
using testing::toy_row;
using testing::toy_rows;

TEST(Database, AGraspIsCalledByItsIdAndNothingWhereThereIsNone) {
  EXPECT_EQ(grasp_name(toy_info(), 9), "Palmar Pinch");
  EXPECT_EQ(grasp_name(toy_info(), 2), "");
}

TEST(Database, GivesBackItsDataCardAndNoneWhereThereIsNone) {
  const TemporaryDirectory directory;
  DatabaseInfo info = toy_info();
  write_database(directory / "none.graspdb", info, toy_rows(1));
  EXPECT_EQ(Database::open(directory / "none.graspdb").info().data_card, "");
  info.data_card = R"({"licence":"MIT"})";
  write_database(directory / "card.graspdb", info, toy_rows(1));
  EXPECT_EQ(Database::open(directory / "card.graspdb").info().data_card, info.data_card);
}

TEST(Database, GivesBackEveryValueOfEveryRow) {
  const TemporaryDirectory directory;
  write_database(directory / "a.graspdb", toy_info(), toy_rows(100));
  const Database database = Database::open(directory / "a.graspdb");
  ASSERT_EQ(database.rows(), 100u);
  for (std::size_t i = 0; i < database.rows(); ++i) {
    const Row row = toy_row(i);
    EXPECT_TRUE(std::ranges::equal(database.label(i), row.label));
    EXPECT_TRUE(std::ranges::equal(database.hog(i), row.hog));
    EXPECT_EQ(database.view(i), row.view);
    EXPECT_EQ(database.grasp(i), row.grasp);
    EXPECT_EQ(database.step(i), row.step);
    EXPECT_EQ(database.hand(i), row.hand);
    EXPECT_EQ(database.box(i), row.box);
    EXPECT_EQ(database.variant(i), row.variant);
    EXPECT_EQ(database.hogs().row(i)[7], row.hog[7]);
  }
  EXPECT_NO_THROW(verify_database(directory / "a.graspdb"));
}

TEST(Database, GivesBackTheInfo) {
  const TemporaryDirectory directory;
  DatabaseInfo written = toy_info();
  written.grasps[1].name = "Pinch \"\\ \xC3\xA9 \n";
  written.processor = "avx512";
  write_database(directory / "a.graspdb", written, {});
  const Database database = Database::open(directory / "a.graspdb");
  const DatabaseInfo& info = database.info();
  ASSERT_EQ(info.grasps.size(), 2u);
  EXPECT_EQ(info.grasps[1].id, 9);
  EXPECT_EQ(info.grasps[1].name, written.grasps[1].name);
  ASSERT_EQ(info.hands.size(), 1u);
  EXPECT_EQ(info.hands[0].name, "toy");
  EXPECT_EQ(skeleton_to_json(info.hands[0].skeleton), skeleton_to_json(written.hands[0].skeleton));
  EXPECT_EQ(info.variants, written.variants);
  EXPECT_EQ(info.camera_distance, written.camera_distance);
  EXPECT_EQ(info.steps, 5);
  EXPECT_EQ(info.views, 8);
  EXPECT_EQ(info.view_rule, "super-fibonacci");
  EXPECT_EQ(info.hog, "paper");
  EXPECT_EQ(info.config, written.config);
  EXPECT_EQ(info.tool, "graspdb test");
  EXPECT_EQ(info.processor, "avx512");
}

TEST(Database, MayHaveNoRows) {
  const TemporaryDirectory directory;
  write_database(directory / "empty.graspdb", toy_info(), {});
  const Database database = Database::open(directory / "empty.graspdb");
  EXPECT_EQ(database.rows(), 0u);
  EXPECT_TRUE(database.hogs().bytes.empty());
  EXPECT_THROW(database.step(0), std::logic_error);
  EXPECT_NO_THROW(verify_database(directory / "empty.graspdb"));
}

TEST(Database, ContentHashTellsRowsApartAndNothingElse) {
  const TemporaryDirectory directory;
  const auto hash_of = [&](const DatabaseInfo& info, const std::vector<Row>& rows) {
    write_database(directory / "a.graspdb", info, rows);
    return Database::open(directory / "a.graspdb").content_hash();
  };
  DatabaseInfo other = toy_info();
  other.tool = "another tool";
  std::vector<Row> rows = toy_rows(3);
  const std::string hash = hash_of(toy_info(), rows);
  EXPECT_EQ(hash_of(other, rows), hash);
  rows[1].hog[5] ^= 1;
  EXPECT_NE(hash_of(toy_info(), rows), hash);
}

TEST(Database, OutlivesAMove) {
  const TemporaryDirectory directory;
  write_database(directory / "a.graspdb", toy_info(), toy_rows(2));
  Database first = Database::open(directory / "a.graspdb");
  const Database second = std::move(first);
  EXPECT_TRUE(std::ranges::equal(second.hog(1), toy_row(1).hog));
}

TEST(WriteDatabase, WritesTheSameBytesTwice) {
  const TemporaryDirectory directory;
  write_database(directory / "a.graspdb", toy_info(), toy_rows(9));
  write_database(directory / "b.graspdb", toy_info(), toy_rows(9));
  EXPECT_EQ(read_text(directory / "a.graspdb"), read_text(directory / "b.graspdb"));
}

TEST(WriteDatabase, RefusesAnInfoThatContradictsItself) {
  const TemporaryDirectory directory;
  const auto refused = [&](const DatabaseInfo& info, const std::string& key) {
    try {
      write_database(directory / "a.graspdb", info, {});
      ADD_FAILURE() << "accepted a wrong " << key;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault().key, key);
      EXPECT_EQ(error.fault().file, (directory / "a.graspdb").string());
    }
  };
  DatabaseInfo info = toy_info();
  info.grasps[1].id = 1;
  refused(info, "grasps.id");
  info.grasps[1].id = 70000;
  refused(info, "grasps.id");
  info = toy_info();
  info.steps = 0;
  refused(info, "steps");
  info = toy_info();
  info.grasps[0].name = "\xFF";
  refused(info, "header");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(WriteDatabase, ChecksItsRows) {
  const TemporaryDirectory directory;
  const auto write = [&](auto change) {
    std::vector<Row> rows = toy_rows(2);
    change(rows[1]);
    write_database(directory / "a.graspdb", toy_info(), rows);
  };
  EXPECT_THROW(write([](Row& row) { row.label[30] = NAN; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.step = 0; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.step = 6; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.view = 8; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.grasp = 2; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.hand = 1; }), std::logic_error);
  EXPECT_THROW(write([](Row& row) { row.variant = 2; }), std::logic_error);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(WriteDatabase, ReportsAPlaceThatCannotBeWritten) {
  EXPECT_THROW(write_database("/proc/nowhere/a.graspdb", toy_info(), {}), Error);
}

}  // namespace
}  // namespace graspdb
