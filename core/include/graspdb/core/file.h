// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace graspdb {

// The whole file as text. Throws Error when it cannot be read, and as require_fetched() does.
std::string read_text(const std::filesystem::path& path);

// Throws Error that says what to do when the file is a Git LFS pointer, which a clone without Git
// LFS leaves in place of a large file. For files that read_text() does not read.
void require_fetched(const std::filesystem::path& path);

// A file that appears under its name only when it is complete: bytes go to a sibling temporary
// file, which commit() flushes to the disk and renames. Destroyed without commit() it leaves
// nothing. The folder is made when there is none; a link is followed. Every failure, a full disk or
// a name that a folder or a device has among them, is an Error that names the final path and the
// system's reason. Not thread-safe.
class FileAside {
 public:
  explicit FileAside(std::filesystem::path path);
  ~FileAside();
  FileAside(const FileAside&) = delete;
  FileAside& operator=(const FileAside&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  void commit();

 private:
  std::string cannot(const char* doing, const std::string& why) const;
  [[noreturn]] void fail(const char* doing) const;

  std::filesystem::path path_;
  std::filesystem::path place_;  // where a link leads
  std::filesystem::path aside_;
  int descriptor_ = -1;
};

// Removes what killed processes of this machine left beside `path` when they were writing it. What
// those of another one, on a disk that both share, are writing there is left alone.
void remove_leftovers(const std::filesystem::path& path);

// Writes a small text file in one go, aside and renamed.
void write_text(const std::filesystem::path& path, std::string_view text);

// Where the project's data (hands, grasps, sequences) lies: what $GRASPDB_DATA names, as it stands;
// else the first of these that holds data:
//   PREFIX/share/graspdb, of a running program PREFIX/bin/NAME
//   the source tree, for a program below the build folder of the project or of one that contains it
//   share/graspdb of the prefix that the library was configured for
// Asks anew at each call. Throws Error naming the places when none of them holds data. Thread-safe
// while nobody changes the environment.
std::filesystem::path data_directory();

}  // namespace graspdb
