// SPDX-License-Identifier: MIT
// build, info, verify, bench and grasp check: what they print and how they refuse.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "program.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lines_of;
using testing::Outcome;
using testing::run_program;
using ::testing::StartsWith;

void expect_refused(const Outcome& outcome, const std::string& told) {
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_EQ(lines_of(outcome.err), 1) << outcome.err;
  EXPECT_THAT(outcome.err, StartsWith("graspdb: "));
  EXPECT_THAT(outcome.err, HasSubstr(told));
}

TEST(DatabaseVerbs, ADatabaseIsBuiltDescribedVerifiedIndexedAndSearched) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "tiny.graspdb").string();
  const Outcome built = testing::build_tiny(file);
  ASSERT_EQ(built.code, 0) << built.err;
  const json report = json::parse(built.out);
  EXPECT_EQ(report.at("rows"), 24);
  EXPECT_EQ(report.at("bytes"), std::filesystem::file_size(file));
  EXPECT_GT(report.at("rows_per_second"), 0);
  EXPECT_GT(report.at("seconds"), 0);

  const json info = json::parse(run_program("info --json " + file).out);
  EXPECT_EQ(info.at("rows"), 24);
  EXPECT_EQ(info.at("content_hash"), report.at("content_hash"));
  EXPECT_EQ(info.at("grasps").at(0).at("id"), 9);
  EXPECT_EQ(info.at("config").at("resolution_px"), 32);
  for (const char* key : {"hands", "variants", "steps", "views", "view_rule", "hog", "tool"})
    EXPECT_TRUE(info.contains(key)) << key;
  EXPECT_EQ(info.at("data_card").at("hands").at(0).at("licence"), "MIT");
  EXPECT_THAT(run_program("info " + file).out, HasSubstr("\nlicence  MIT: "));

  EXPECT_EQ(run_program("verify " + file).code, 0);
  const json bench =
      json::parse(run_program("bench --json --queries 3 -k 2 --frames 2 " + file).out);
  ASSERT_EQ(bench.at("searches").size(), 3u);
  EXPECT_EQ(bench.at("searches").at(0).at("search"), "exact");
  EXPECT_EQ(bench.at("searches").at(0).at("recall"), 1);

  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
      .seekp(-1, std::ios::end)
      .put('\x7f');
  expect_refused(run_program("verify " + file), file);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  expect_refused(run_program("info " + file), file);
}

// With the project's own weights.
TEST(DatabaseVerbs, RowsHaveCodesWhereADescriptorIsAskedFor) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "learned.graspdb").string();
  const std::string build = "build --only 9 --steps 1 --views 24 --resolution 32 --out ";
  const std::string weights =
      " --descriptor " + (data_directory() / "assets/descriptors/hand.safetensors").string();
  const Outcome built = run_program(build + file + weights);
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_EQ(run_program("verify " + file).code, 0);
  EXPECT_THAT(run_program("info " + file).out, HasSubstr("learned  hand, "));
  const json info = json::parse(run_program("info --json " + file).out);
  EXPECT_EQ(info.at("descriptor").at("name"), "hand");

  // As the file says itself, but for the codes.
  const std::string plain = (directory / "plain.graspdb").string();
  ASSERT_EQ(run_program("build --config " + file + " --descriptor none --out " + plain).code, 0);
  EXPECT_EQ(json::parse(run_program("info --json " + plain).out).at("descriptor"), json());
  EXPECT_LT(fs::file_size(plain), fs::file_size(file));
}

TEST(DatabaseVerbs, AConfigurationThatIsNoJsonIsRefusedWithTheFile) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "x.graspdb").string();
  DatabaseInfo info = testing::toy_info();
  info.config = "{\"views\": ";
  write_database(file, info, testing::toy_rows(1));
  EXPECT_EQ(run_program("info " + file).code, 0);
  expect_refused(run_program("info --json " + file), file + ": 'config'");
}

TEST(DatabaseVerbs, AFailedBuildLeavesNothing) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "x.graspdb").string();
  expect_refused(run_program("build --only 999 --out " + file), "999");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(DatabaseVerbs, AShardIsTwoNumbersAndNothingElse) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "x.graspdb").string();
  for (const char* shard : {"1/3x", "1", "3/3", "1/99999999999"}) {
    expect_refused(run_program(std::string("build --shard ") + shard + " --out " + file),
                   "--shard");
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(DatabaseVerbs, AnOptionStandsOverTheConfigurationsHand) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "tiny.graspdb").string();
  ASSERT_EQ(testing::build_tiny(file).code, 0);
  const std::string child = GRASPDB_SOURCE_DIR "/assets/hands/child.glb";
  const Outcome built =
      run_program("build --config " + file + " --hand " + child + " --out " + file + "2");
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_EQ(json::parse(run_program("info --json " + file + "2").out).at("hands").at(0), "child");
}

TEST(DatabaseVerbs, MissingAndForeignFilesAreNamed) {
  const testing::TemporaryDirectory directory;
  const std::string file = (directory / "text.graspdb").string();
  expect_refused(run_program("info " + file), file);
  write_text(file, "no database at all");
  for (const char* verb : {"info ", "verify ", "bench "})
    expect_refused(run_program(verb + file), file);
}

TEST(DatabaseVerbs, AGraspsCheckIsTold) {
  const std::string grasps = GRASPDB_SOURCE_DIR "/grasps/";
  std::string file;
  for (const auto& entry : std::filesystem::directory_iterator(grasps)) {
    if (entry.path().filename().string().starts_with("09")) file = entry.path().string();
  }
  ASSERT_FALSE(file.empty());
  const Outcome outcome = run_program("grasp check --json " + file);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json grasp = json::parse(outcome.out).at("grasps").at(0);
  EXPECT_EQ(grasp.at("id"), 9);
  EXPECT_EQ(grasp.at("pass"), true);
  for (const char* key :
       {"step", "penetration_mm", "volume_cm3", "self_penetration_mm", "contacts", "clearance_mm"})
    EXPECT_TRUE(grasp.at("steps").at(0).contains(key)) << key;
}

TEST(DatabaseVerbs, DiffTellsWhatDiffers) {
  const testing::TemporaryDirectory directory;
  const std::string a = (directory / "a").string(), b = (directory / "b").string(),
                    c = (directory / "c").string();
  const std::string build = "build --only 9 --steps 1 --views 24 --resolution 32 --out ";
  ASSERT_EQ(run_program(build + a).code, 0);
  ASSERT_EQ(run_program(build + b + " --threads 1").code, 0);
  ASSERT_EQ(run_program(build + c + " --forearm 30").code, 0);
  const Outcome same = run_program("diff " + a + " " + b);
  EXPECT_EQ(same.code, 0);
  EXPECT_THAT(same.out, StartsWith("the same: 24 rows"));
  const Outcome different = run_program("diff " + a + " " + c);
  EXPECT_EQ(different.code, 1);
  EXPECT_THAT(different.out, HasSubstr("visible_forearm_m"));
  EXPECT_THAT(different.out, HasSubstr("hog: "));
  EXPECT_THAT(different.out, ::testing::Not(HasSubstr("label: ")));
}

}  // namespace
}  // namespace graspdb
