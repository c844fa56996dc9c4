// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>

#include "graspdb/image.h"

namespace graspdb::cli {

// Writes an .mp4 (MPEG-4) that appears under its name only when finish() was called.
class VideoWriter {
 public:
  VideoWriter(std::filesystem::path path, double frames_per_second);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  void write(const ColorImage& frame);  // all of one size
  void finish();

 private:
  std::filesystem::path path_, aside_;
  double frames_per_second_;
  cv::VideoWriter writer_;
};

}  // namespace graspdb::cli
