// SPDX-License-Identifier: MIT
#include "program.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {

Outcome run_program(const std::string& arguments) {
  const TemporaryDirectory directory;
  const auto out = directory / "out", err = directory / "err";
  const int status = std::system(
      fmt::format("{} {} >{} 2>{}", GRASPDB_PROGRAM, arguments, out.string(), err.string())
          .c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out), read_text(err)};
}

Outcome build_tiny(const std::filesystem::path& file) {
  return run_program("build --json --only 9 --steps 1 --views 24 --resolution 32 --out " +
                     file.string());
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace graspdb::testing
