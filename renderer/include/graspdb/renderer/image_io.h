// SPDX-License-Identifier: MIT
// Pictures in files, through OpenImageIO: PNG for 8 and 16 bits, EXR for float32. Writing is aside
// and renamed; faults are Errors that name the file, and so is a picture of more than 256 MiB.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "graspdb/core/image.h"

namespace graspdb {

void write_png(const std::filesystem::path& path, const GrayImage& image);
void write_png(const std::filesystem::path& path, const ColorImage& image);  // from BGR
void write_png16(const std::filesystem::path& path, const Image<std::uint16_t>& image);
void write_exr(const std::filesystem::path& path, const Image<float>& image);  // one channel, "Z"
void write_exr(const std::filesystem::path& path,
               const Image<Eigen::Vector3f>& image);  // x, y, z as channels "R", "G", "B"

// What follows reads a picture as a viewer shows it: upright by its EXIF orientation, of square
// pixels, on black where it is transparent. A picture that ends early is an Error.
struct Picture {
  ColorImage color;
  std::vector<std::string> notes;  // what was done to it, a sentence each
  // Of a film 36 mm wide and 24 high that would show as much, by EXIF; 0 when the file does not
  // say.
  double focal_35mm = 0;
};
Picture read_picture(const std::filesystem::path& path);
ColorImage read_color(const std::filesystem::path& path);
GrayImage read_gray(const std::filesystem::path& path);

// Grey as the file counts it, so that labels stay what they are.
struct Levels {
  Image<std::uint16_t> gray;
  int white = 255;           // the highest level that the file could have: 255 or 65535
  bool transparent = false;  // somewhere; there it is black
};
Levels read_levels(const std::filesystem::path& path);

}  // namespace graspdb
