// SPDX-License-Identifier: MIT
#include "frame_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <opencv2/videoio.hpp>
#include <set>

#include "graspdb/error.h"
#include "graspdb/image_io.h"

namespace graspdb::cli {
namespace {

namespace fs = std::filesystem;

ColorImage to_image(const cv::Mat& frame) {
  ColorImage image(frame.cols, frame.rows);
  for (int y = 0; y < frame.rows; ++y) {
    std::copy_n(reinterpret_cast<const Bgr*>(frame.ptr(y)), frame.cols, image.row(y));
  }
  return image;
}

bool is_picture(const fs::path& path) {
  static const std::set<std::string> kEndings = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return kEndings.contains(ending);
}

std::vector<fs::path> pictures_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_picture(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw Error(
        {.file = folder.string(), .expected = "pictures (.png, .jpg ...)", .found = "none"});
  return files;
}

// The mask named like the frame, with any ending.
Mask read_mask(const fs::path& folder, const fs::path& frame, const ColorImage& color) {
  for (const char* ending : {".png", ".jpg", ".bmp"}) {
    const fs::path file = folder / (frame.stem().string() + ending);
    if (!fs::exists(file)) continue;
    Mask mask = read_gray(file);
    for (std::uint8_t& pixel : mask) pixel = pixel > 127 ? 255 : 0;
    if (mask.width() == color.width() && mask.height() == color.height()) return mask;
    throw Error({file.string(), "",
                 fmt::format("a mask of {} x {} pixels", color.width(), color.height()),
                 fmt::format("{} x {}", mask.width(), mask.height())});
  }
  throw Error({folder.string(), frame.stem().string(), "a mask of that name", "none"});
}

class Pictures : public FrameSource {
 public:
  Pictures(const fs::path& folder, fs::path masks)
      : files_(pictures_of(folder)), masks_(std::move(masks)) {}
  // A rendered sequence: frames, noisy masks unless others are given, camera and truth.
  Pictures(WrittenSequence sequence, const fs::path& masks)
      : Pictures(sequence.directory / "frames",
                 masks.empty() ? sequence.directory / "noisy" : masks) {
    sequence_ = std::move(sequence);
  }

  std::optional<InputFrame> next() override {
    if (next_ == files_.size()) return std::nullopt;
    const fs::path& file = files_[next_];
    InputFrame frame{.index = static_cast<int>(next_),
                     .time = static_cast<double>(next_) / frames_per_second()};
    frame.color = read_color(file);
    if (!masks_.empty()) frame.mask = read_mask(masks_, file, frame.color);
    ++next_;
    return frame;
  }
  double frames_per_second() const override {
    return sequence_ ? sequence_->frames_per_second : 10;
  }
  std::optional<std::size_t> count() const override { return files_.size(); }
  const WrittenSequence* sequence() const override { return sequence_ ? &*sequence_ : nullptr; }

 private:
  std::vector<fs::path> files_;
  fs::path masks_;
  std::optional<WrittenSequence> sequence_;
  std::size_t next_ = 0;
};

class Video : public FrameSource {
 public:
  Video(const std::string& input, fs::path masks) : masks_(std::move(masks)) {
    const std::string camera = "camera:";
    const bool live = input.starts_with(camera);
    const bool opened =
        live ? capture_.open(std::atoi(input.c_str() + camera.size())) : capture_.open(input);
    if (!opened)
      throw Error({.file = input,
                   .expected = "a video, a folder of pictures or camera:N",
                   .found = "nothing that opens"});
    if (!live)
      count_ = static_cast<std::size_t>(std::max(0.0, capture_.get(cv::CAP_PROP_FRAME_COUNT)));
  }

  std::optional<InputFrame> next() override {
    cv::Mat frame;
    if (!capture_.read(frame)) return std::nullopt;
    InputFrame result{
        .index = next_, .time = next_ / frames_per_second(), .color = to_image(frame)};
    if (!masks_.empty()) result.mask = read_mask(masks_, fmt::format("{:06}", next_), result.color);
    ++next_;
    return result;
  }
  double frames_per_second() const override {
    const double rate = capture_.get(cv::CAP_PROP_FPS);
    return rate > 0 ? rate : 30;
  }
  std::optional<std::size_t> count() const override { return count_; }

 private:
  cv::VideoCapture capture_;
  fs::path masks_;
  std::optional<std::size_t> count_;
  int next_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_source(const std::string& input, const fs::path& masks) {
  if (fs::exists(fs::path(input) / "sequence.json")) {
    return std::make_unique<Pictures>(read_sequence(input), masks);
  }
  if (fs::is_directory(input)) return std::make_unique<Pictures>(input, masks);
  return std::make_unique<Video>(input, masks);
}

}  // namespace graspdb::cli
