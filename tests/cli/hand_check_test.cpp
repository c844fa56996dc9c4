// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run_program;
using testing::TemporaryDirectory;

const std::string kMale = GRASPDB_SOURCE_DIR "/assets/hands/male.glb";

// The same hand under another name, whose makers are unknown: the arguments that name it.
std::string as_other_hand(const TemporaryDirectory& directory) {
  std::filesystem::copy_file(kMale, directory / "other.glb");
  return (directory / "other.glb").string() + " --rig " GRASPDB_SOURCE_DIR
                                              "/assets/hands/male.rig.toml";
}

json line_of(const json& check, const std::string& name) {
  for (const json& line : check.at("lines")) {
    if (line.at("name") == name) return line;
  }
  ADD_FAILURE() << "no line " << name;
  return {};
}

bool any_fails(const json& check) {
  const json& lines = check.at("lines");
  return std::any_of(lines.begin(), lines.end(),
                     [](const json& line) { return line.at("status") == "fail"; });
}

TEST(HandCheckVerb, JsonHoldsEveryLineAndAgreesWithTheExitCode) {
  const Outcome outcome = run_program("hand check --json " + kMale);
  const json check = json::parse(outcome.out);
  EXPECT_EQ(check.at("hand"), "male");
  EXPECT_GE(check.at("triangles"), 8000);
  EXPECT_EQ(check.at("pass"), !any_fails(check));
  EXPECT_EQ(outcome.code, any_fails(check) ? 1 : 0) << outcome.err;
  EXPECT_GT(check.at("lines").size(), 40);
  for (const json& line : check.at("lines")) {
    EXPECT_TRUE(line.at("value").is_number() || line.at("value").is_null());
    for (const char* key : {"name", "unit", "gate", "status", "why"}) {
      EXPECT_TRUE(line.at(key).is_string()) << key;
    }
  }
  // What our own hands were asked to be is known from their names.
  EXPECT_EQ(line_of(check, "hand length").at("status"), "pass");
  EXPECT_EQ(line_of(check, "hand breadth").at("status"), "pass");
  EXPECT_EQ(line_of(check, "made again").at("status"), "pass");
  EXPECT_EQ(line_of(check, "bind identity").at("status"), "pass");
}

TEST(HandCheckVerb, OurOwnHandPassesEveryLine) {
  const Outcome outcome = run_program("hand check " + kMale);
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("FAIL")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("n/a")));
}

TEST(HandCheckVerb, AnotherNameIsNobodysHand) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program("hand check --json " + as_other_hand(directory));
  const json check = json::parse(outcome.out);
  EXPECT_EQ(line_of(check, "made again").at("status"), "not applicable");
  EXPECT_TRUE(line_of(check, "made again").at("value").is_null());
  EXPECT_EQ(line_of(check, "hand length").at("status"), "not applicable");
  EXPECT_NEAR(line_of(check, "hand length").at("value"), 193, 2);
}

TEST(HandCheckVerb, AFailingLineIsPrintedAndExitsWithOne) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program("hand check " + as_other_hand(directory) + " --length-mm 180 --breadth-mm 88");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("FAIL hand length"));
  EXPECT_THAT(outcome.out, HasSubstr("178.2..181.8"));
  EXPECT_THAT(outcome.out, HasSubstr("ok   hand breadth"));
  EXPECT_THAT(outcome.err, HasSubstr("lines fail"));
}

TEST(HandCheckVerb, BadInputIsNamed) {
  EXPECT_EQ(run_program("hand check none.glb").code, 1);
  EXPECT_THAT(run_program("hand check none.glb").err, HasSubstr("none.glb"));
  EXPECT_THAT(run_program("hand check " + kMale + " --rig none.toml").err, HasSubstr("none.toml"));
}

TEST(HandCheckVerb, LengthAndBreadthGoTogether) {
  EXPECT_EQ(run_program("hand check " + kMale + " --length-mm 180").code, 2);
  EXPECT_EQ(run_program("hand check " + kMale + " --length-mm 18 --breadth-mm 88").code, 2);
  EXPECT_EQ(run_program("hand check").code, 2);
}

}  // namespace
}  // namespace graspdb
