// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace graspdb {

// The EXIF orientation of a PNG, which OpenImageIO 2.4 does not read; 1 when it has none that can
// be read.
int png_orientation(const std::filesystem::path& file);

}  // namespace graspdb
