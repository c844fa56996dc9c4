// SPDX-License-Identifier: MIT
#include "graspdb/video/video_writer.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

cv::Mat fitted(const cv::Mat& frame, const cv::Size& size) {
  const double scale = std::min(1.0 * size.width / frame.cols, 1.0 * size.height / frame.rows);
  const cv::Size inner(std::max(1, static_cast<int>(frame.cols * scale)),
                       std::max(1, static_cast<int>(frame.rows * scale)));
  cv::Mat result(size, CV_8UC3, cv::Scalar::all(0));
  const cv::Point corner((size.width - inner.width) / 2, (size.height - inner.height) / 2);
  cv::Mat target = result(cv::Rect(corner, inner));
  cv::resize(frame, target, inner, 0, 0, cv::INTER_AREA);
  return result;
}

int frames_in(const std::filesystem::path& video) {
  const cv::VideoCapture capture(video.string(), cv::CAP_FFMPEG);
  return capture.isOpened() ? static_cast<int>(capture.get(cv::CAP_PROP_FRAME_COUNT)) : 0;
}

}  // namespace

VideoWriter::VideoWriter(std::filesystem::path path, double frames_per_second)
    : path_(std::move(path)), frames_per_second_(frames_per_second) {
  // The encoder chooses its container by the ending, so that the mark goes before it.
  aside_ = path_;
  aside_.replace_extension(fmt::format(".{}.tmp{}", ::getpid(), path_.extension().string()));
}

VideoWriter::~VideoWriter() {
  writer_.release();
  std::error_code ignored;  // after finish() there is none
  std::filesystem::remove(aside_, ignored);
}

void VideoWriter::open(const cv::Size& size) {
  std::error_code ignored;  // opening reports what matters
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), ignored);
  if (!writer_.open(aside_.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('m', 'p', '4', 'v'),
                    frames_per_second_, size)) {
    throw Error({.file = path_.string(),
                 .expected = "a video file that can be written (.mp4)",
                 .found = "an encoder that refuses it"});
  }
  size_ = size;
}

void VideoWriter::write(const ColorImage& frame) {
  // The writer only reads the pixels.
  const cv::Mat pixels(frame.height(), frame.width(), CV_8UC3, const_cast<Bgr*>(frame.data()));
  if (!writer_.isOpened()) open(pixels.size());
  writer_.write(pixels.size() == size_ ? pixels : fitted(pixels, size_));
  ++written_;
}

void VideoWriter::finish() {
  if (!writer_.isOpened()) return;
  writer_.release();
  // The encoder does not tell when the disk is full.
  if (const int found = frames_in(aside_); found != written_) {
    throw Error({path_.string(), "", fmt::format("{} frames in the written video", written_),
                 fmt::format("{} (is the disk full?)", found)});
  }
  std::error_code fault;
  std::filesystem::rename(aside_, path_, fault);
  if (fault)
    throw Error(fmt::format("{}: cannot rename into place: {}", path_.string(), fault.message()));
}

}  // namespace graspdb
