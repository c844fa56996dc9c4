// SPDX-License-Identifier: MIT
// Pictures in files, through OpenImageIO: PNG for 8 and 16 bits, EXR for float32. Writing is aside
// and renamed; faults are Errors that name the file, and so is a picture of more than 256 MiB.
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "graspdb/core/image.h"

namespace graspdb {

void write_png(const std::filesystem::path& path, const GrayImage& image);
void write_png(const std::filesystem::path& path, const ColorImage& image);  // from BGR
void write_png16(const std::filesystem::path& path, const Image<std::uint16_t>& image);
void write_exr(const std::filesystem::path& path, const Image<float>& image);  // one channel, "Z"
void write_exr(const std::filesystem::path& path,
               const Image<Eigen::Vector3f>& image);  // x, y, z as channels "R", "G", "B"
GrayImage read_gray(const std::filesystem::path& path);
ColorImage read_color(const std::filesystem::path& path);  // to BGR; EXIF rotation is not applied

}  // namespace graspdb
