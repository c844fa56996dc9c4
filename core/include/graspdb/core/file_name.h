// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace graspdb {

// The extension of a file's name with its dot, in small letters: ".png" of "a.PNG".
std::string lower_extension(const std::filesystem::path& file);

}  // namespace graspdb
