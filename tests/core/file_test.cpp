// SPDX-License-Identifier: MIT
#include "graspdb/core/file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

TEST(File, IsAbsentUntilCommitted) {
  const testing::TemporaryDirectory directory;
  const auto path = directory / "a.txt";
  {
    FileAside file(path);
    file.write("half");
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
  write_text(path, "whole");
  EXPECT_EQ(read_text(path), "whole");
}

TEST(File, AFullDiskIsAnErrorThatNamesTheFile) {
  try {
    FileAside file("/dev/full/x");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full/x"));
  }
}

TEST(File, AGitLfsPointerIsNamedWithWhatToDo) {
  const testing::TemporaryDirectory directory;
  write_text(directory / "hand.glb",
             "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n");
  write_text(directory / "versions.txt", "version https://git-scm.com\n");
  const auto refusal = [](const auto& read) -> std::string {
    try {
      read();
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal([&] { read_text(directory / "hand.glb"); }), HasSubstr("git lfs pull"));
  EXPECT_THAT(refusal([&] { require_fetched(directory / "hand.glb"); }), HasSubstr("hand.glb"));
  EXPECT_EQ(refusal([&] { require_fetched(directory / "versions.txt"); }), "accepted");
  EXPECT_EQ(refusal([&] { require_fetched(directory / "absent"); }), "accepted");
}

TEST(File, AMissingFileIsAnErrorThatNamesIt) {
  try {
    read_text("/nowhere/at.all");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/at.all"));
  }
}

TEST(File, ANameThatNoFileCanHaveIsAnErrorToo) {
  EXPECT_THROW(read_text("/tmp/" + std::string(300, 'x')), Error);
  EXPECT_THROW(read_text(std::string(10000, '/') + "tmp"), Error);
}

TEST(File, AnEmptyFileReadsAsNothing) {
  const testing::TemporaryDirectory directory;
  write_text(directory / "empty", "");
  EXPECT_EQ(read_text(directory / "empty"), "");
}

std::string refusal_of(const std::filesystem::path& path) {
  try {
    FileAside file(path);
    file.commit();
  } catch (const Error& error) {
    return error.what();
  }
  return "written";
}

TEST(File, NeverTakesThePlaceOfAFolderOrADevice) {
  const testing::TemporaryDirectory directory;
  EXPECT_THAT(refusal_of(directory.path()), HasSubstr("found a folder"));
  const auto pipe = directory / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal_of(pipe), HasSubstr("a device or a pipe"));
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(File, IsWrittenWhereALinkLeads) {
  const testing::TemporaryDirectory directory;
  write_text(directory / "far/file", "old");
  std::filesystem::create_symlink("far/file", directory / "link");
  write_text(directory / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
  EXPECT_EQ(read_text(directory / "far/file"), "new");
}

TEST(File, SaysWhyTheSystemRefuses) {
  const testing::TemporaryDirectory directory;
  write_text(directory / "file", "");
  EXPECT_THAT(refusal_of(directory / "file/inside"), HasSubstr("Not a directory"));
  EXPECT_THAT(refusal_of("/proc/self/folder/file"), HasSubstr("No such file"));
  try {
    read_text(directory / "file/inside");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("Not a directory"));
  }
}

TEST(File, LeftoversOfKilledWritersAreRemovedAndNoOthers) {
  const testing::TemporaryDirectory directory;
  const auto path = directory / "a.txt";
  const pid_t killed = ::fork();
  if (killed == 0) {
    FileAside file(path);
    ::_exit(0);  // no destructor runs
  }
  ::waitpid(killed, nullptr, 0);
  FileAside alive(path);
  write_text(path.string() + ".elsewhere." + std::to_string(killed) + ".tmp", "of another machine");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(directory.path()), {});
  };
  EXPECT_EQ(files(), 3);
  remove_leftovers(path);
  EXPECT_EQ(files(), 2);
  alive.commit();
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST(Hash, MatchesThePublishedValueOfTheEmptyInput) {
  EXPECT_EQ(hash_hex(std::string_view()), "99aa06d3014798d86001c324468d497f");
}

}  // namespace
}  // namespace graspdb
