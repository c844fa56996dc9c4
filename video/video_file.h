// SPDX-License-Identifier: MIT
// A video's frames as a player shows them: upright, of square pixels, each at its own time. Through
// FFmpeg itself: OpenCV 4.6 turns frames the wrong way, has no time for the last ones, and takes
// the first damaged packet for the end.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/image.h"
#include "graspdb/core/pixel_layout.h"
#include "graspdb/core/remarks.h"

struct AVCodecContext;
struct AVFormatContext;
struct AVFrame;
struct AVPacket;
struct AVStream;
struct SwsContext;

namespace graspdb {

struct VideoFrame {
  ColorImage color;
  double time = 0;                 // seconds since the first frame
  std::vector<std::string> notes;  // what was done to it and not to the one before
};

class VideoFile {
 public:
  explicit VideoFile(const std::string& path);  // throws Error for what is no video
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  std::optional<VideoFrame> next();          // none at the end
  double frames_per_second() const;          // on average
  std::optional<std::size_t> count() const;  // as the file announces it
  // What was wrong with it; complete at the end.
  std::vector<std::string> warnings() const;

 private:
  struct Free {
    void operator()(AVFormatContext* format) const;
    void operator()(AVCodecContext* decoder) const;
    void operator()(AVFrame* frame) const;
    void operator()(AVPacket* packet) const;
    void operator()(SwsContext* scaler) const;
  };
  template <typename T>
  using Owned = std::unique_ptr<T, Free>;

  [[noreturn]] void fail(const char* found) const;
  void open_decoder();
  void feed();
  void see_end_of(const AVPacket& packet);
  double seconds_between_frames() const;  // as they came
  std::optional<double> announced_seconds() const;
  std::optional<std::int64_t> announced_frames() const;
  bool ends_early() const;
  VideoFrame shown(AVFrame& frame);
  ColorImage pixels_of(const AVFrame& frame);
  PixelLayout layout_of(AVFrame& frame) const;
  double time_of(const AVFrame& frame);
  std::vector<std::string> news(const AVFrame& frame, const PixelLayout& layout);

  std::string path_;
  Owned<AVFormatContext> format_;
  AVStream* stream_ = nullptr;  // the format's
  Owned<AVCodecContext> decoder_;
  Owned<AVFrame> frame_, bgr_;
  Owned<AVPacket> packet_;
  Owned<SwsContext> scaler_;
  bool drained_ = false;
  std::int64_t packets_ = 0, frames_ = 0;
  int faults_ = 0;               // packets and frames that are damaged
  double end_ = 0;               // of the last packet, seconds by the file's clock
  double last_ = 0;              // when the last frame was shown, seconds since the first
  std::optional<double> first_;  // when the first frame is shown, by the file's clock
  std::optional<PixelLayout> told_;
  std::string stopped_by_;  // why reading stopped before the end
};

}  // namespace graspdb
