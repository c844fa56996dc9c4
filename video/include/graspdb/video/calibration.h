// SPDX-License-Identifier: MIT
// A camera as other programs calibrate it.
#pragma once

#include <filesystem>

#include "graspdb/core/camera.h"

namespace graspdb {

struct CameraCalibration {
  Intrinsics camera;       // width and height are 0 when the file states none
  bool distorted = false;  // the lens bends lines, which is not undone here
};

// Reads what OpenCV's calibration writes (YAML or JSON: camera_matrix, image_width,
// image_height, distortion_coefficients), COLMAP's cameras.txt with one camera, or the nine numbers
// of a matrix row by row. Throws Error naming file and key for anything else.
CameraCalibration read_calibration(const std::filesystem::path& file);

// The same camera when it takes pictures of another size. Throws Error naming `file` when their
// sides have other proportions.
Intrinsics scaled_to(const Intrinsics& camera, int width, int height,
                     const std::filesystem::path& file);

}  // namespace graspdb
