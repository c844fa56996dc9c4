// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace graspdb {

// The EXIF orientation in a chunk of a PNG or a WebP, which OpenImageIO 2.4 does not read; 1 when
// there is none that can be read, and for all other files.
int orientation_in_chunk(const std::filesystem::path& file);

// Whether a PNG states a chunk that is longer than what is left of the file: libpng would make room
// for it first, and that can be 2 GB in a file of 60 bytes.
bool is_png_with_a_chunk_beyond_its_end(const std::filesystem::path& file);

}  // namespace graspdb
