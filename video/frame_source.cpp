// SPDX-License-Identifier: MIT
#include "graspdb/video/frame_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <opencv2/videoio.hpp>
#include <set>
#include <tuple>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/renderer/image_io.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path) {
  static const std::set<std::string> kEndings = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return kEndings.contains(ending);
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// A text that sorts numbers in a name by value: each goes without leading zeros after its length.
std::string natural_key(const std::string& name) {
  std::string key;
  for (auto at = name.begin(); at != name.end();) {
    if (!is_digit(*at)) {
      key += *at++;
      continue;
    }
    const auto end = std::find_if_not(at, name.end(), is_digit);
    at = std::find_if(at, end, [](char c) { return c != '0'; });
    key += fmt::format("{:03}{}", end - at, std::string(at, end));
    at = end;
  }
  return key;
}

bool naturally_before(const fs::path& a, const fs::path& b) {
  const std::string a_key = natural_key(a.filename().string());
  const std::string b_key = natural_key(b.filename().string());
  return std::tie(a_key, a) < std::tie(b_key, b);
}

std::vector<fs::path> pictures_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_picture(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), naturally_before);
  if (files.empty())
    throw Error(
        {.file = folder.string(), .expected = "pictures (.png, .jpg ...)", .found = "none"});
  return files;
}

// The mask named like the frame, with any ending.
Mask find_mask(const fs::path& folder, const fs::path& frame, const ColorImage& color) {
  for (const char* ending : {".png", ".jpg", ".bmp"}) {
    const fs::path file = folder / (frame.stem().string() + ending);
    if (fs::exists(file)) return read_mask(file, color);
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
    if (files_.size() == sequence_->truth.size()) return;
    throw Error({sequence_->directory.string(), "frames/",
                 fmt::format("{} pictures, as truth.jsonl has lines", sequence_->truth.size()),
                 fmt::format("{}", files_.size())});
  }

  std::optional<InputFrame> next() override {
    if (next_ == files_.size()) return std::nullopt;
    const fs::path& file = files_[next_];
    InputFrame frame{.index = static_cast<int>(next_),
                     .time = static_cast<double>(next_) / frames_per_second()};
    frame.color = read_color(file);
    if (!masks_.empty()) frame.mask = find_mask(masks_, file, frame.color);
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
  Video(const std::string& input, fs::path masks) : input_(input), masks_(std::move(masks)) {
    const std::optional<int> camera = camera_number(input);
    if (!camera && !fs::is_regular_file(input)) fail("no such file");
    // Other backends than FFmpeg would take names of files for patterns and devices.
    if (!(camera ? capture_.open(*camera) : capture_.open(input, cv::CAP_FFMPEG)))
      fail(camera ? "no camera that opens" : "a file that is no video");
    const double count = camera ? 0 : capture_.get(cv::CAP_PROP_FRAME_COUNT);
    if (count > 0) count_ = static_cast<std::size_t>(count);
  }

  std::optional<InputFrame> next() override {
    cv::Mat frame;
    if (!capture_.read(frame)) return std::nullopt;
    if (frame.type() != CV_8UC3) fail("frames that are not 8-bit colour");
    InputFrame result{
        .index = next_, .time = next_ / frames_per_second(), .color = to_color_image(frame)};
    if (!masks_.empty()) result.mask = find_mask(masks_, fmt::format("{:06}", next_), result.color);
    ++next_;
    return result;
  }
  double frames_per_second() const override {
    const double rate = capture_.get(cv::CAP_PROP_FPS);
    return rate > 0 ? rate : 30;
  }
  std::optional<std::size_t> count() const override { return count_; }

 private:
  [[noreturn]] void fail(const char* found) const {
    throw Error(
        {.file = input_, .expected = "a video, a folder of pictures or camera:N", .found = found});
  }

  std::string input_;
  cv::VideoCapture capture_;
  fs::path masks_;
  std::optional<std::size_t> count_;
  int next_ = 0;
};

}  // namespace

std::optional<int> camera_number(const std::string& input) {
  if (!input.starts_with(kCameraPrefix)) return std::nullopt;
  const char* const end = input.data() + input.size();
  int number = -1;
  const auto [rest, fault] = std::from_chars(input.data() + kCameraPrefix.size(), end, number);
  return fault == std::errc() && rest == end && number >= 0 ? std::optional(number) : std::nullopt;
}

bool is_sequence(const fs::path& input) {
  return fs::exists(input / "sequence.json");
}

Mask read_mask(const fs::path& file, const ColorImage& color) {
  Mask mask = read_gray(file);
  for (std::uint8_t& pixel : mask) pixel = pixel > 127 ? 255 : 0;
  if (mask.width() == color.width() && mask.height() == color.height()) return mask;
  throw Error({file.string(), "",
               fmt::format("a mask of {} x {} pixels", color.width(), color.height()),
               fmt::format("{} x {}", mask.width(), mask.height())});
}

std::unique_ptr<FrameSource> open_source(const std::string& input, const fs::path& masks) {
  if (is_sequence(input)) return std::make_unique<Pictures>(read_sequence(input), masks);
  if (fs::is_directory(input)) return std::make_unique<Pictures>(input, masks);
  return std::make_unique<Video>(input, masks);
}

}  // namespace graspdb
