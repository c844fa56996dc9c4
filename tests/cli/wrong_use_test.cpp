// SPDX-License-Identifier: MIT
// Wrong use is told on stderr with exit code 2; what is asked for goes to stdout with 0.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <sstream>

#include "graspdb/core/file.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
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
  expect_wrong_use("samples --out x.safetensors --hog edgy", "--hog");
  expect_wrong_use("track db in --finder pale", "--finder");
  expect_wrong_use("track db in --roi 1,2,0,4", "--roi");
  expect_wrong_use("track db in --roi 1,2,3,-4", "--roi");
  expect_wrong_use("track db in --roi 1,2,3,4000000000", "--roi");
  expect_wrong_use("track db in --video overlay.avi", ".mp4");
}

const std::vector<std::string> kVerbs = {
    "build",     "merge",      "info",       "verify",      "diff",        "query",
    "render",    "export",     "track",      "sequence",    "eval",        "tune",
    "bench",     "grasp list", "grasp new",  "grasp close", "grasp check", "grasp sheet",
    "hand make", "hand check", "hand sheet", "find",        "samples",     "scenes"};

// "--steps" of "  --steps N    Steps ..." for each option whose value is written so.
std::vector<std::string> options_with(const std::string& value, const std::string& help) {
  std::vector<std::string> options;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::string names, written;
    std::istringstream(line) >> names >> written;
    const std::size_t name = names.find("--");
    if (name != names.npos && (written == value || written.starts_with(value + ",")))
      options.push_back(names.substr(name));
  }
  return options;
}

TEST(WrongUse, HelpIsWrittenInWords) {
  for (const std::string& verb : kVerbs) {
    const Outcome help = run_program(verb + " --help");
    EXPECT_EQ(help.code, 0) << verb;
    for (const char* raw : {":INT", ":FLOAT", ":value", " in [", "->", "=[", "ENUM", "REQUIRED",
                            "Option Group", "[]", "{", "2147483647"}) {
      EXPECT_THAT(help.out, Not(HasSubstr(raw))) << verb;
    }
  }
  EXPECT_THAT(run_program("build --help").out,
              ContainsRegex("--steps N +Steps from rest to the closed hand .1 to 20. .5."));
}

TEST(WrongUse, NoOptionTakesWhatIsNoNumber) {
  std::size_t numbers = 0, whole_numbers = 0;
  for (const std::string& verb : kVerbs) {
    const std::string help = run_program(verb + " --help").out;
    for (const std::string& option : options_with("X", help)) {
      ++numbers;
      expect_wrong_use(fmt::format("{} {} nan", verb, option), option);
    }
    for (const std::string& option : options_with("N", help)) {
      ++whole_numbers;
      expect_wrong_use(fmt::format("{} {} -999999", verb, option), option);
    }
  }
  EXPECT_GT(numbers, 20u);
  EXPECT_GT(whole_numbers, 20u);
}

TEST(WrongUse, AnEmptyTextIsNotTakenForNone) {
  for (const char* command :
       {"build --out x --config", "build --out x --hand", "build --out x --grasps",
        "build --out x --preset", "build --out", "hand sheet", "track", "eval d --sequences"}) {
    expect_wrong_use(std::string(command) + " ''", "empty");
  }
}

TEST(WrongUse, APlaceThatCannotBeWrittenIsToldBeforeTheWork) {
  const testing::TemporaryDirectory directory;
  const std::string folder = directory.path().string(), file = (directory / "file").string();
  write_text(file, "mine");
  for (const char* command :
       {"build --out", "grasp sheet --out", "hand make --out", "track d v --json",
        "track d v --video", "query d i --out", "info d --sheet"}) {
    expect_wrong_use(fmt::format("{} {}", command, folder), "expected a file");
    expect_wrong_use(fmt::format("{} {}/inside.png", command, file), "");
  }
  for (const char* command :
       {"export d --out", "render --grasp 9 --out", "sequence s --out", "sequence s --meshes",
        "eval d --sequences s --out", "grasp new n --out"}) {
    expect_wrong_use(fmt::format("{} {}", command, file), "is no folder");
  }
  EXPECT_EQ(read_text(file), "mine");
}

TEST(WrongUse, AFormatThatIsNotWrittenIsRefused) {
  expect_wrong_use("hand make --out h.obj", ".glb");
  expect_wrong_use("hand sheet h.glb --out s.jpg", ".png");
  expect_wrong_use("info d --sheet s.tif", ".png");
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
  expect_wrong_use("track db camera:0 --masks masks", "--masks");
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
