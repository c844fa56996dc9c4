// SPDX-License-Identifier: MIT
// Wrong use is told on stderr with exit code 2; what is asked for goes to stdout with 0.
#include <gmock/gmock.h>

#include "program.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Outcome;
using testing::run_program;

void expect_wrong_use(const std::string& arguments, const std::string& told) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.code, 2) << arguments;
  EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(told)) << arguments;
}

TEST(WrongUse, HelpAndVersionGoToStdout) {
  for (const char* arguments : {"--help", "--version", "track --help"}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("graspdb"));
    EXPECT_THAT(outcome.err, IsEmpty());
  }
}

TEST(WrongUse, AnUnknownVerbIsNamed) {
  expect_wrong_use("tarck db video.mp4", "no such verb: tarck");
  expect_wrong_use("grasp chekc", "no such verb: chekc");
  expect_wrong_use("", "required");
}

TEST(WrongUse, ValuesOutOfRangeAreRefused) {
  expect_wrong_use("build --out x --hog edgy", "--hog");
  expect_wrong_use("build --out x --renderer blender", "--renderer");
  expect_wrong_use("track db in --skin pale", "--skin");
  expect_wrong_use("track db in --roi 1,2,0,4", "--roi");
  expect_wrong_use("track db in --roi 1,2,3,-4", "--roi");
  expect_wrong_use("track db in --roi 1,2,3,4000000000", "--roi");
  expect_wrong_use("track db in --video overlay.avi", ".mp4");
}

TEST(WrongUse, APresetIsOneOfThoseThatThereAre) {
  const Outcome unknown = run_program("build --out x --preset papers");
  EXPECT_EQ(unknown.code, 1);
  EXPECT_THAT(unknown.err, HasSubstr("paper, tracking"));
  expect_wrong_use("build --out x --preset paper --config mine.toml", "excludes");
}

TEST(WrongUse, ACameraIsANumber) {
  for (const char* camera : {"camera:", "camera:x", "camera:1x", "camera:-1"})
    expect_wrong_use(std::string("track db ") + camera, "camera:N");
}

TEST(WrongUse, ListsDoNotSwallowWhatFollows) {
  // The database is told to be missing, not the argument.
  const Outcome outcome = run_program("eval --sequences s --alphas 0,1 none.graspdb");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("none.graspdb"));
  expect_wrong_use("build --only 1,2 stray --out x", "stray");
}

}  // namespace
}  // namespace graspdb
