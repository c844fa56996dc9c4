// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace graspdb {

// The EXIF orientation in a chunk of a PNG or a WebP, which OpenImageIO 2.4 does not read; 1 when
// there is none that can be read, and for all other files.
int orientation_in_chunk(const std::filesystem::path& file);

}  // namespace graspdb
