// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cstdlib>

#include "data_places.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const ConfiguredFolders kConfigured{
    .source = "/src", .build = "/src/build/release", .installed_data = "/usr/local/share/graspdb"};

TEST(DataPlaces, AnInstalledProgramHasThoseOfItsPrefixAndNotTheSources) {
  EXPECT_THAT(data_places("/opt/tools/bin/graspdb", kConfigured),
              ElementsAre("/opt/tools/share/graspdb", "/usr/local/share/graspdb"));
}

TEST(DataPlaces, AProgramOfTheBuildTreeHasTheSources) {
  EXPECT_THAT(data_places("/src/build/release/cli/graspdb", kConfigured),
              ElementsAre("/src/build/release/share/graspdb", "/src", "/usr/local/share/graspdb"));
}

TEST(DataPlaces, AFolderBesideTheBuildTreeIsNotBelowIt) {
  EXPECT_THAT(data_places("/src/build/release2/cli/graspdb", kConfigured),
              ElementsAre("/src/build/release2/share/graspdb", "/usr/local/share/graspdb"));
}

TEST(DataPlaces, AnUnknownProgramHasTheConfiguredPrefix) {
  EXPECT_THAT(data_places("", kConfigured), ElementsAre("/usr/local/share/graspdb"));
}

TEST(DataPlaces, TheFirstThatHoldsHandsIsTaken) {
  const testing::TemporaryDirectory directory;
  for (const char* name : {"empty", "first/assets/hands", "second/assets/hands"})
    fs::create_directories(directory / name);
  EXPECT_EQ(first_with_data({directory / "absent", directory / "empty", directory / "first",
                             directory / "second"}),
            directory / "first");
}

TEST(DataPlaces, WithoutDataTheErrorNamesThemAll) {
  try {
    first_with_data({"/nowhere/a", "/nowhere/b"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/a, /nowhere/b"));
    EXPECT_THAT(error.what(), HasSubstr("GRASPDB_DATA"));
  }
}

// Sets GRASPDB_DATA, or takes it away, until the end of a test.
class DataDirectory : public ::testing::Test {
 protected:
  DataDirectory() {
    if (const char* before = std::getenv("GRASPDB_DATA")) before_ = before;
  }
  ~DataDirectory() override {
    ::unsetenv("GRASPDB_DATA");
    if (before_) ::setenv("GRASPDB_DATA", before_->c_str(), 1);
  }

  std::optional<std::string> before_;
};

TEST_F(DataDirectory, IsTheOneThatIsNamed) {
  ::setenv("GRASPDB_DATA", "/some/where", 1);
  EXPECT_EQ(data_directory(), "/some/where");
}

TEST_F(DataDirectory, OfThisTestIsTheSourceTree) {
  ::unsetenv("GRASPDB_DATA");
  EXPECT_EQ(data_directory(), GRASPDB_SOURCE_DIR);
}

TEST_F(DataDirectory, AnEmptyNameNamesNone) {
  ::setenv("GRASPDB_DATA", "", 1);
  EXPECT_EQ(data_directory(), GRASPDB_SOURCE_DIR);
}

}  // namespace
}  // namespace graspdb
