// SPDX-License-Identifier: MIT
#include "blender.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>

#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {

bool has_blender() {
  static const bool found = std::system("command -v blender >/dev/null") == 0;
  return found;
}

namespace {

std::string opened(const std::filesystem::path& scene) {
  if (scene.empty()) return "";
  return fmt::format("{} '{}'", scene.extension() == ".py" ? "--python" : "", scene.string());
}

}  // namespace

BlenderOutcome run_blender(const std::filesystem::path& scene, const std::filesystem::path& script,
                           const std::vector<std::string>& arguments) {
  const TemporaryDirectory directory;
  const std::string out = (directory / "out").string();
  const std::filesystem::path root = GRASPDB_SOURCE_DIR;
  // The user's settings would make it another Blender; a script that fails must show.
  const std::string command = fmt::format(
      "blender -b --factory-startup --python-exit-code 1 {} --python '{}' -- '{}' >'{}' 2>&1",
      opened(scene), (root / script).string(), fmt::join(arguments, "' '"), out);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out)};
}

}  // namespace graspdb::testing
