// SPDX-License-Identifier: MIT
// Which camera took each frame.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/video/calibration.h"
#include "graspdb/video/frame_source.h"

namespace graspdb::cli {

struct CameraSettings {
  std::string file;  // a calibration
  double focal_px = 0;
  std::vector<double> principal_px;  // x, y; empty: the middle
};

void add_camera_options(CLI::App& verb, CameraSettings& settings);

class TrackCamera {
 public:
  // Throws Error for a calibration that cannot be read.
  explicit TrackCamera(const CameraSettings& settings);

  // In this order: of a rendered sequence, the calibration, as stated, the photograph's own EXIF,
  // guessed. Throws Error for frames that do not fit the sequence or the calibration.
  Intrinsics of(const InputFrame& frame, const WrittenSequence* sequence);
  // Of the last frame: "sequence", "calibration", "--focal", "EXIF" or "guess".
  const std::string& origin() const { return origin_; }
  bool distorted() const { return calibration_ && calibration_->distorted; }

 private:
  CameraSettings settings_;
  std::optional<CameraCalibration> calibration_;
  std::string origin_;
};

}  // namespace graspdb::cli
