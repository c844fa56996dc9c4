// SPDX-License-Identifier: MIT
#include "graspdb/core/folder.h"

#include <gmock/gmock.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

const FolderContent kPictures{
    .kind = "pictures", .marker = ".pictures", .files = {"a/" + digits(3) + ".png", "list.txt"}};

class Folder : public ::testing::Test {
 protected:
  void expect_refused(const std::string& because) {
    try {
      renew_folder(folder_, kPictures);
      ADD_FAILURE() << "taken over";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(folder_.string()), HasSubstr(because)));
    }
  }
  void put(const fs::path& file) { write_text(folder_ / file, "x"); }

  testing::TemporaryDirectory directory_;
  fs::path folder_ = directory_ / "deep/folder";
};

TEST_F(Folder, IsMadeAndTakenOverAgain) {
  renew_folder(folder_, kPictures);
  put("a/001.png");
  put("list.txt");
  put("a/002.png.host.17.tmp");  // of a writer that was killed
  claim_folder(folder_, kPictures);
  EXPECT_TRUE(fs::exists(folder_ / "a/001.png"));
  renew_folder(folder_, kPictures);
  EXPECT_FALSE(fs::exists(folder_ / "a"));
  EXPECT_FALSE(fs::exists(folder_ / "list.txt"));
  EXPECT_TRUE(fs::exists(folder_ / ".pictures"));
}

TEST_F(Folder, WithFilesOfTheSameNamesButNoMarkerIsNotOurs) {
  put("a/001.png");
  expect_refused("a/001.png, but no .pictures");
  EXPECT_TRUE(fs::exists(folder_ / "a/001.png"));
}

TEST_F(Folder, IsTakenOverFromAWriterThatWasKilledAtTheMarker) {
  put(".pictures.host.17.tmp");
  renew_folder(folder_, kPictures);
  EXPECT_TRUE(fs::exists(folder_ / ".pictures"));
  EXPECT_FALSE(fs::exists(folder_ / ".pictures.host.17.tmp"));
}

TEST_F(Folder, WithAnythingElseIsRefusedAndKept) {
  for (const char* name : {"notes.txt", "a/holiday.png", "a/b/001.png", "b/001.png", ".hidden"}) {
    fs::remove_all(folder_);
    claim_folder(folder_, kPictures);
    put("a/001.png");
    put(name);
    expect_refused(name);
    EXPECT_TRUE(fs::exists(folder_ / name));
    EXPECT_TRUE(fs::exists(folder_ / "a/001.png"));
  }
}

TEST_F(Folder, DoesNotFollowLinksToOtherFolders) {
  claim_folder(folder_, kPictures);
  const fs::path elsewhere = directory_ / "elsewhere";
  write_text(elsewhere / "001.png", "x");
  fs::create_directory_symlink(elsewhere, folder_ / "a");
  expect_refused("found a");
  EXPECT_TRUE(fs::exists(elsewhere / "001.png"));
}

TEST_F(Folder, CannotBeWhereAFileIs) {
  write_text(folder_, "x");
  expect_refused("a folder");
}

}  // namespace
}  // namespace graspdb
