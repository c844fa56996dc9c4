// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>

#include "graspdb/core/file.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {
namespace {

using ::testing::HasSubstr;

// A file system of its own needs a name space of one's own.
bool may_mount() {
  return std::system("unshare -rm true 2>/dev/null") == 0;
}

// Builds in a tmpfs: first of so many bytes, then with space enough. Both outputs are in `err`, the
// files that are left after the first in `out`.
Outcome build_on_small_disk(int bytes) {
  const TemporaryDirectory directory;
  const std::string build = fmt::format(
      "{} build --only 3,9 --objects both --steps 1 --views 40 --resolution 32 --threads 1 --out "
      "a.graspdb 2>>{}/err",
      GRASPDB_PROGRAM, directory.path().string());
  write_text(directory / "run.sh",
             fmt::format("mount -t tmpfs -o size={0} none {1}/disk && cd {1}/disk || exit 9\n"
                         "if {2} >/dev/null; then exit 8; fi\n"
                         "test ! -e a.graspdb || exit 7\n"
                         "ls a.graspdb.work >{1}/out\n"
                         "mount -o remount,size=10m {1}/disk && {2} >>{1}/out\n",
                         bytes, directory.path().string(), build));
  std::filesystem::create_directory(directory / "disk");
  const int status =
      std::system(fmt::format("unshare -rm sh {}", (directory / "run.sh").string()).c_str());
  return {status, read_text(directory / "out"), read_text(directory / "err")};
}

// Four shards of 35 kB and a database of 112 kB.
TEST(FullDisk, LeavesFinishedShardsAndNoHalfFileAndSaysWhatToDo) {
  if (!may_mount()) GTEST_SKIP() << "this machine lets nobody mount";
  for (const int bytes : {20'000, 100'000, 180'000}) {
    const Outcome outcome = build_on_small_disk(bytes);
    EXPECT_EQ(outcome.code, 0) << bytes << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("No space left on device"));
    EXPECT_THAT(outcome.err, HasSubstr("of 4 shards are finished in a.graspdb.work: the same"));
    EXPECT_THAT(outcome.out, Not(HasSubstr(".tmp")));
    EXPECT_THAT(outcome.out, HasSubstr("a.graspdb: 160 rows"));
  }
}

}  // namespace
}  // namespace graspdb::testing
