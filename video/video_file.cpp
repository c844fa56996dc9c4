// SPDX-License-Identifier: MIT
#include "video_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "graspdb/core/error.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace graspdb {
namespace {

// [a b . c d . x y .]: a stored (right, down) is shown at (a right + c down, b right + d down).
// None for a turn that is no multiple of 90 degrees.
std::optional<int> orientation_of(const std::int32_t* matrix) {
  const std::int64_t a = matrix[0], b = matrix[1], c = matrix[3], d = matrix[4];
  const std::int64_t straight = std::min(std::abs(a), std::abs(d)),
                     across = std::min(std::abs(b), std::abs(c));
  constexpr int kMuch = 100;
  if (straight > kMuch * std::max(std::abs(b), std::abs(c))) {
    constexpr std::array kStraight = {1, 2, 4, 3};
    return kStraight.at((a < 0 ? 1 : 0) + (d < 0 ? 2 : 0));
  }
  if (across > kMuch * std::max(std::abs(a), std::abs(d))) {
    constexpr std::array kAcross = {5, 6, 8, 7};
    return kAcross.at((c < 0 ? 1 : 0) + (b < 0 ? 2 : 0));
  }
  return std::nullopt;
}

const std::int32_t* matrix_of(const AVStream& stream, const AVFrame& frame) {
  const void* matrix = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
  if (matrix == nullptr) {
    const AVFrameSideData* data = av_frame_get_side_data(&frame, AV_FRAME_DATA_DISPLAYMATRIX);
    if (data != nullptr) matrix = data->data;
  }
  return static_cast<const std::int32_t*>(matrix);
}

bool has_alpha(const AVFrame& frame) {
  const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(static_cast<AVPixelFormat>(frame.format));
  return format != nullptr && (format->flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
}

// Of the times that belong to no stream.
double seconds(std::int64_t ticks) {
  return static_cast<double>(ticks) / AV_TIME_BASE;
}

std::string text_of(int fault) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(fault, text.data(), text.size());
  return text.data();
}

// Only this very file: a playlist may name others, and addresses.
AVFormatContext* open_format(const std::string& path) {
  AVDictionary* options = nullptr;
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  AVFormatContext* format = nullptr;
  const int fault = avformat_open_input(&format, ("file:" + path).c_str(), nullptr, &options);
  av_dict_free(&options);
  return fault < 0 ? nullptr : format;
}

// Such a one is read without its EXIF.
bool is_still(const AVFormatContext& format) {
  const std::string_view name = format.iformat->name;
  return name == "image2" || name.ends_with("_pipe");
}

}  // namespace

void VideoFile::Free::operator()(AVFormatContext* format) const {
  avformat_close_input(&format);
}
void VideoFile::Free::operator()(AVCodecContext* decoder) const {
  avcodec_free_context(&decoder);
}
void VideoFile::Free::operator()(AVFrame* frame) const {
  av_frame_free(&frame);
}
void VideoFile::Free::operator()(AVPacket* packet) const {
  av_packet_free(&packet);
}
void VideoFile::Free::operator()(SwsContext* scaler) const {
  sws_freeContext(scaler);
}

VideoFile::VideoFile(const std::string& path) : path_(path) {
  av_log_set_level(AV_LOG_QUIET);  // faults are told once, by warnings()
  format_.reset(open_format(path));
  if (!format_ || avformat_find_stream_info(format_.get(), nullptr) < 0)
    fail("a file that is no video");
  if (is_still(*format_)) fail("a picture of another kind than .png, .jpg, .bmp and .tif");
  open_decoder();
  frame_.reset(av_frame_alloc());
  bgr_.reset(av_frame_alloc());
  packet_.reset(av_packet_alloc());
  GRASPDB_CHECK(frame_ && bgr_ && packet_);
}

VideoFile::~VideoFile() = default;

void VideoFile::fail(const char* found) const {
  throw Error({.file = path_, .expected = "a video", .found = found});
}

void VideoFile::open_decoder() {
  const AVCodec* codec = nullptr;
  const int number = av_find_best_stream(format_.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0);
  if (number < 0) fail("a file without pictures that can be decoded");
  stream_ = format_->streams[number];
  decoder_.reset(avcodec_alloc_context3(codec));
  GRASPDB_CHECK(decoder_ != nullptr);
  decoder_->thread_count = 0;  // as many as there are processors
  decoder_->pkt_timebase = stream_->time_base;
  if (avcodec_parameters_to_context(decoder_.get(), stream_->codecpar) < 0 ||
      avcodec_open2(decoder_.get(), codec, nullptr) < 0)
    fail("pictures that cannot be decoded");
}

std::optional<VideoFrame> VideoFile::next() {
  for (;;) {
    const int answer = avcodec_receive_frame(decoder_.get(), frame_.get());
    if (answer == 0) return shown(*frame_);
    if (answer == AVERROR_EOF || (drained_ && answer == AVERROR(EAGAIN))) return std::nullopt;
    if (answer != AVERROR(EAGAIN)) ++faults_;
    feed();
  }
}

// One packet to the decoder, or the news that there are no more.
void VideoFile::feed() {
  const int answer = av_read_frame(format_.get(), packet_.get());
  if (answer < 0) {
    if (answer != AVERROR_EOF) stopped_by_ = text_of(answer);
    avcodec_send_packet(decoder_.get(), nullptr);
    drained_ = true;
    return;
  }
  see_end_of(*packet_);
  if (packet_->stream_index == stream_->index) {
    ++packets_;
    // A damaged packet is not the end of what can be read.
    if (avcodec_send_packet(decoder_.get(), packet_.get()) < 0) ++faults_;
  }
  av_packet_unref(packet_.get());
}

void VideoFile::see_end_of(const AVPacket& packet) {
  if (packet.pts == AV_NOPTS_VALUE) return;
  const AVRational base = format_->streams[packet.stream_index]->time_base;
  end_ = std::max(end_, static_cast<double>(packet.pts + packet.duration) * av_q2d(base));
}

VideoFrame VideoFile::shown(AVFrame& frame) {
  if (frame.decode_error_flags != 0 || (frame.flags & AV_FRAME_FLAG_CORRUPT) != 0) ++faults_;
  const PixelLayout layout = layout_of(frame);
  VideoFrame result{.time = time_of(frame), .notes = news(frame, layout)};
  result.color = as_shown(pixels_of(frame), layout);
  last_ = result.time;
  ++frames_;
  return result;
}

// By way of a frame with padded rows, as the scaler writes some pixels beyond their end.
ColorImage VideoFile::pixels_of(const AVFrame& frame) {
  scaler_.reset(sws_getCachedContext(
      scaler_.release(), frame.width, frame.height, static_cast<AVPixelFormat>(frame.format),
      frame.width, frame.height, AV_PIX_FMT_BGR24, SWS_BICUBIC, nullptr, nullptr, nullptr));
  if (!scaler_) fail("pixels of a kind that cannot be read");
  if (bgr_->width != frame.width || bgr_->height != frame.height) {
    av_frame_unref(bgr_.get());
    bgr_->format = AV_PIX_FMT_BGR24;
    bgr_->width = frame.width;
    bgr_->height = frame.height;
    if (av_frame_get_buffer(bgr_.get(), 0) < 0) fail("frames for which there is no memory");
  }
  sws_scale(scaler_.get(), frame.data, frame.linesize, 0, frame.height, bgr_->data, bgr_->linesize);
  ColorImage color(frame.width, frame.height);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = bgr_->data[0] + static_cast<std::ptrdiff_t>(y) * bgr_->linesize[0];
    std::copy_n(reinterpret_cast<const Bgr*>(row), frame.width, color.row(y));
  }
  return color;
}

PixelLayout VideoFile::layout_of(AVFrame& frame) const {
  const AVRational aspect = av_guess_sample_aspect_ratio(format_.get(), stream_, &frame);
  const std::int32_t* matrix = matrix_of(*stream_, frame);
  return checked_layout(matrix == nullptr ? 1 : orientation_of(matrix).value_or(1),
                        aspect.den == 0 ? 1 : av_q2d(aspect), path_);
}

double VideoFile::time_of(const AVFrame& frame) {
  const std::int64_t ticks = frame.best_effort_timestamp;
  if (ticks == AV_NOPTS_VALUE) return static_cast<double>(frames_) / frames_per_second();
  const double time = static_cast<double>(ticks) * av_q2d(stream_->time_base);
  if (!first_) first_ = time;
  return time - *first_;
}

std::vector<std::string> VideoFile::news(const AVFrame& frame, const PixelLayout& layout) {
  if (told_ == layout) return {};
  told_ = layout;
  std::vector<std::string> notes = notes_on(layout, "display matrix");
  const std::int32_t* matrix = matrix_of(*stream_, frame);
  if (matrix != nullptr && !orientation_of(matrix)) {
    notes.push_back(fmt::format("not turned: its display matrix asks for {:.4g} degrees clockwise",
                                -av_display_rotation_get(matrix)));
  }
  if (has_alpha(frame)) notes.push_back("its transparency is not applied");
  return notes;
}

double VideoFile::frames_per_second() const {
  const double rate = av_q2d(av_guess_frame_rate(format_.get(), stream_, nullptr));
  return rate > 0 && std::isfinite(rate) ? rate : 30;
}

std::optional<std::size_t> VideoFile::count() const {
  if (stream_->nb_frames > 0) return static_cast<std::size_t>(stream_->nb_frames);
  return std::nullopt;
}

double VideoFile::seconds_between_frames() const {
  return frames_ > 1 ? last_ / static_cast<double>(frames_ - 1) : 1 / frames_per_second();
}

std::optional<double> VideoFile::announced_seconds() const {
  if (format_->duration_estimation_method != AVFMT_DURATION_FROM_STREAM ||
      format_->duration == AV_NOPTS_VALUE)
    return std::nullopt;
  return seconds(format_->duration);
}

// An AVI may count moments without a frame, too: twice what fits into its seconds is no count.
std::optional<std::int64_t> VideoFile::announced_frames() const {
  if (stream_->nb_frames <= 0) return std::nullopt;
  const std::optional<double> length = announced_seconds();
  const double fitting = length.value_or(INFINITY) / seconds_between_frames();
  if (static_cast<double>(stream_->nb_frames) > 2 * fitting) return std::nullopt;
  return stream_->nb_frames;
}

// Fewer packets than announced may be an edit list's, and seconds without a frame another stream's:
// a file that announces both must lack both. The last frame may have no length.
bool VideoFile::ends_early() const {
  const std::optional<std::int64_t> frames = announced_frames();
  if (frames && packets_ >= *frames) return false;
  const std::optional<double> length = announced_seconds();
  if (!length) return frames.has_value();
  const double begin = format_->start_time == AV_NOPTS_VALUE ? 0 : seconds(format_->start_time);
  const double gap = seconds_between_frames();
  return *length - (end_ - begin) > (frames ? gap / 2 : std::max(2 * gap, 0.25));
}

std::vector<std::string> VideoFile::warnings() const {
  std::vector<std::string> warnings;
  if (drained_ && ends_early()) {
    const std::optional<std::int64_t> frames = announced_frames();
    warnings.push_back(
        frames ? fmt::format("the file ends early: {} of the {} frames that it announces", frames_,
                             *frames)
               : fmt::format(
                     "the file ends early: {} frames, {:.1f} of the {:.1f} s that it announces",
                     frames_, last_, *announced_seconds()));
  }
  if (!stopped_by_.empty()) warnings.push_back("it cannot be read to its end: " + stopped_by_);
  if (faults_ > 0) warnings.push_back(fmt::format("damaged packets or frames: {}", faults_));
  return warnings;
}

}  // namespace graspdb
