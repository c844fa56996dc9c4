// SPDX-License-Identifier: MIT
#include "graspdb/video/frame_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <opencv2/videoio.hpp>
#include <tuple>

#include "graspdb/core/error.h"
#include "graspdb/core/file_name.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/stopwatch.h"
#include "graspdb/renderer/image_io.h"
#include "video_file.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

constexpr std::array kPictureEndings = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};

bool is_picture(const fs::path& path) {
  return std::ranges::find(kPictureEndings, lower_extension(path)) != kPictureEndings.end();
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

// Whether they are named as frames are: a text that all share and a number that grows by one.
bool count_up(const std::vector<fs::path>& files) {
  std::optional<std::pair<std::string, std::int64_t>> last;
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    const auto digits = std::find_if_not(stem.rbegin(), stem.rend(), is_digit).base();
    std::int64_t number = -1;
    std::from_chars(stem.data() + (digits - stem.begin()), stem.data() + stem.size(), number);
    const std::string text(stem.begin(), digits);
    if (number < 0 || (last && *last != std::pair(text, number - 1))) return false;
    last = {text, number};
  }
  return files.size() > 1;
}

// The diagonal of film is what EXIF compares.
double focal_px(const Picture& picture) {
  static const double kFilmDiagonal = std::hypot(36, 24);  // mm
  return picture.focal_35mm * std::hypot(picture.color.width(), picture.color.height()) /
         kFilmDiagonal;
}

// The mask named like the frame, with any ending.
Mask find_mask(const fs::path& folder, const fs::path& frame, const ColorImage& color) {
  for (const char* ending : kPictureEndings) {
    const fs::path file = folder / (frame.stem().string() + ending);
    if (fs::exists(file)) return read_mask(file, color);
  }
  throw Error({folder.string(), frame.stem().string(), "a mask of that name", "none"});
}

class Pictures : public FrameSource {
 public:
  Pictures(std::vector<fs::path> files, fs::path masks)
      : files_(std::move(files)), masks_(std::move(masks)), count_up_(count_up(files_)) {}
  // A rendered sequence: frames, noisy masks unless others are given, camera and truth.
  Pictures(WrittenSequence sequence, const fs::path& masks)
      : Pictures(pictures_of(sequence.directory / "frames"),
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
                     .time = static_cast<double>(next_) / frames_per_second(),
                     .file = file.filename().string()};
    Picture picture = read_picture(file);
    frame.color = std::move(picture.color);
    frame.notes = std::move(picture.notes);
    frame.focal_px = focal_px(picture);
    if (!masks_.empty()) frame.mask = find_mask(masks_, file, frame.color);
    ++next_;
    return frame;
  }
  double frames_per_second() const override {
    return sequence_ ? sequence_->frames_per_second : 10;
  }
  std::optional<std::size_t> count() const override { return files_.size(); }
  bool unrelated() const override { return !sequence_ && !count_up_; }
  const WrittenSequence* sequence() const override { return sequence_ ? &*sequence_ : nullptr; }

 private:
  std::vector<fs::path> files_;
  fs::path masks_;
  bool count_up_;
  std::optional<WrittenSequence> sequence_;
  std::size_t next_ = 0;
};

class Video : public FrameSource {
 public:
  Video(const std::string& input, fs::path masks) : file_(input), masks_(std::move(masks)) {}

  std::optional<InputFrame> next() override {
    std::optional<VideoFrame> shown = file_.next();
    if (!shown) return std::nullopt;
    InputFrame frame{.index = next_, .time = shown->time, .color = std::move(shown->color)};
    frame.notes = std::move(shown->notes);
    if (!masks_.empty()) frame.mask = find_mask(masks_, fmt::format("{:06}", next_), frame.color);
    ++next_;
    return frame;
  }
  double frames_per_second() const override { return file_.frames_per_second(); }
  std::optional<std::size_t> count() const override { return file_.count(); }
  std::vector<std::string> warnings() const override { return file_.warnings(); }

 private:
  VideoFile file_;
  fs::path masks_;
  int next_ = 0;
};

// A camera states no times: the clock says when its frames come.
class LiveCamera : public FrameSource {
 public:
  LiveCamera(const std::string& input, int number) : input_(input) {
    if (!capture_.open(number)) fail("no camera that opens");
  }

  std::optional<InputFrame> next() override {
    cv::Mat frame;
    if (!capture_.read(frame)) return std::nullopt;
    if (frame.type() != CV_8UC3) fail("frames that are not 8-bit colour");
    if (!since_first_) since_first_.emplace();
    return InputFrame{
        .index = next_++, .time = since_first_->ms() / 1000, .color = to_color_image(frame)};
  }
  double frames_per_second() const override {
    const double rate = capture_.get(cv::CAP_PROP_FPS);
    return rate > 0 ? rate : 30;
  }
  std::optional<std::size_t> count() const override { return std::nullopt; }

 private:
  [[noreturn]] void fail(const char* found) const {
    throw Error({.file = input_, .expected = "a camera", .found = found});
  }

  std::string input_;
  cv::VideoCapture capture_;
  std::optional<Stopwatch> since_first_;
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

std::unique_ptr<FrameSource> open_source(const std::string& input, const fs::path& masks) {
  if (const std::optional<int> camera = camera_number(input))
    return std::make_unique<LiveCamera>(input, *camera);
  if (is_sequence(input)) return std::make_unique<Pictures>(read_sequence(input), masks);
  if (fs::is_directory(input)) return std::make_unique<Pictures>(pictures_of(input), masks);
  if (!fs::is_regular_file(input)) {
    throw Error({.file = input,
                 .expected = "a video, a picture, a folder of pictures or camera:N",
                 .found = "no such file"});
  }
  if (is_picture(input)) return std::make_unique<Pictures>(std::vector<fs::path>{input}, masks);
  return std::make_unique<Video>(input, masks);
}

}  // namespace graspdb
