// SPDX-License-Identifier: MIT
#include "video_writer.h"

#include <fmt/format.h>
#include <unistd.h>

#include "graspdb/error.h"

namespace graspdb::cli {

VideoWriter::VideoWriter(std::filesystem::path path, double frames_per_second)
    : path_(std::move(path)), frames_per_second_(frames_per_second) {
  // The encoder chooses its container by the ending, so that the mark goes before it.
  aside_ = path_;
  aside_.replace_extension(fmt::format(".{}.tmp{}", ::getpid(), path_.extension().string()));
}

VideoWriter::~VideoWriter() {
  std::error_code ignored;
  if (writer_.isOpened()) {
    writer_.release();
    std::filesystem::remove(aside_, ignored);
  }
}

void VideoWriter::write(const ColorImage& frame) {
  if (!writer_.isOpened() &&
      !writer_.open(aside_.string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'),
                    frames_per_second_, {frame.width(), frame.height()})) {
    throw Error({.file = path_.string(),
                 .expected = "a video file that can be written (.mp4)",
                 .found = "an encoder that refuses it"});
  }
  // The writer only reads the pixels.
  writer_.write(cv::Mat(frame.height(), frame.width(), CV_8UC3, const_cast<Bgr*>(frame.data())));
}

void VideoWriter::finish() {
  if (!writer_.isOpened()) return;
  writer_.release();
  std::filesystem::rename(aside_, path_);
}

}  // namespace graspdb::cli
