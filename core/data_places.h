// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace graspdb {

// What was known when the library was configured.
struct ConfiguredFolders {
  std::filesystem::path source;
  std::filesystem::path build;  // its real path
  std::filesystem::path installed_data;
};

// Where the data of this running program may lie, the best place first. `program` is its file;
// empty when that is not known.
std::vector<std::filesystem::path> data_places(const std::filesystem::path& program,
                                               const ConfiguredFolders& configured);

// The first of them that holds data. Throws Error that names all of them.
std::filesystem::path first_with_data(const std::vector<std::filesystem::path>& places);

}  // namespace graspdb
