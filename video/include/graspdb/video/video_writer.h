// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>

#include "graspdb/core/image.h"

namespace graspdb {

// Writes an .mp4 (MPEG-4) that appears under its name only when finish() was called and every frame
// is in it; otherwise nothing is left. Folders on the way are created.
class VideoWriter {
 public:
  VideoWriter(std::filesystem::path path, double frames_per_second);
  ~VideoWriter();
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;

  // A frame of another size than the first one's is fitted into it between black bars.
  void write(const ColorImage& frame);
  void finish();  // throws Error when frames are missing, as on a full disk

 private:
  void open(const cv::Size& size);

  std::filesystem::path path_, aside_;
  double frames_per_second_;
  cv::VideoWriter writer_;
  cv::Size size_;
  int written_ = 0;
};

}  // namespace graspdb
