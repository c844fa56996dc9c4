// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstdlib>

#include "data_places.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"

namespace graspdb {

namespace fs = std::filesystem;

namespace {

bool is_below(const fs::path& file, const fs::path& folder) {
  const fs::path inside = file.lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

}  // namespace

std::vector<fs::path> data_places(const fs::path& program, const ConfiguredFolders& configured) {
  std::vector<fs::path> places;
  if (!program.empty()) places.push_back(program.parent_path().parent_path() / "share/graspdb");
  if (is_below(program, configured.build)) places.push_back(configured.source);
  places.push_back(configured.installed_data);
  return places;
}

fs::path first_with_data(const std::vector<fs::path>& places) {
  std::string tried;
  for (const fs::path& place : places) {
    std::error_code ignored;
    if (fs::is_directory(place / "assets/hands", ignored)) return place;
    tried += fmt::format("{}{}", tried.empty() ? "" : ", ", place.string());
  }
  throw Error(
      fmt::format("the data of graspdb was not found in {}: set GRASPDB_DATA to the folder that "
                  "holds assets/ and grasps/",
                  tried));
}

fs::path data_directory() {
  if (const char* named = std::getenv("GRASPDB_DATA"); named && *named) return named;
  std::error_code unknown;  // a system without /proc
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return first_with_data(
      data_places(program, {GRASPDB_SOURCE_DIR, GRASPDB_BUILD_DIR, GRASPDB_INSTALLED_DATA}));
}

}  // namespace graspdb
