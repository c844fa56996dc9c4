// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace graspdb::cli {

// Writes a commented grasp file to start from into a folder, which is made when it is not there:
// 100_jar_lid.toml for "Jar Lid", with the lowest number from 100 that no grasp file there has.
// Returns its path. Throws Error for a name that no file can have, and never overwrites.
std::filesystem::path write_new_grasp(const std::string& name,
                                      const std::filesystem::path& directory);

}  // namespace graspdb::cli
