// SPDX-License-Identifier: MIT
// Small videos of four colours, and what a container may say of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>

extern "C" {
#include <libavformat/avformat.h>
}

namespace graspdb::testing {

// Red and green over blue and white, 64 x 32 pixels; 10 frames a second. "avc1" has frames whose
// order in the file is not the one in which they are shown.
inline void write_video(const std::filesystem::path& file, int frames, const char* codec = "mp4v") {
  const cv::Size size(64, 32);
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG,
                         cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), 10, size);
  ASSERT_TRUE(writer.isOpened()) << codec;
  for (int i = 0; i < frames; ++i) {
    cv::Mat frame(size, CV_8UC3, cv::Scalar(255, 255, 255));
    frame(cv::Rect(0, 0, 32, 16)) = cv::Scalar(0, 0, 255);
    frame(cv::Rect(32, 0, 32, 16)) = cv::Scalar(0, 255, 0);
    frame(cv::Rect(0, 16, 32, 16)) = cv::Scalar(255, 0, 0);
    cv::circle(frame, {10 + i % 44, 16}, 4, cv::Scalar::all(0), cv::FILLED);  // something moves
    writer.write(frame);
  }
}

// What is changed when a video is written again: its stream's properties, or its packets.
struct Changes {
  std::function<void(AVStream&)> stream = [](AVStream&) {};
  std::function<void(AVPacket&, int)> packet = [](AVPacket&, int) {};
};

// The same packets in another container, whose header comes first.
inline void write_again(const std::filesystem::path& from, const std::filesystem::path& to,
                        const Changes& changes) {
  AVFormatContext *in = nullptr, *out = nullptr;
  ASSERT_EQ(avformat_open_input(&in, from.c_str(), nullptr, nullptr), 0);
  ASSERT_GE(avformat_find_stream_info(in, nullptr), 0);
  ASSERT_GE(avformat_alloc_output_context2(&out, nullptr, nullptr, to.c_str()), 0);
  AVStream& stream = *avformat_new_stream(out, nullptr);
  avcodec_parameters_copy(stream.codecpar, in->streams[0]->codecpar);
  stream.codecpar->codec_tag = 0;
  stream.time_base = in->streams[0]->time_base;
  stream.avg_frame_rate = in->streams[0]->avg_frame_rate;
  changes.stream(stream);
  stream.codecpar->sample_aspect_ratio = stream.sample_aspect_ratio;
  ASSERT_GE(avio_open(&out->pb, to.c_str(), AVIO_FLAG_WRITE), 0);
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "faststart", 0);
  ASSERT_GE(avformat_write_header(out, &options), 0);
  av_dict_free(&options);
  AVPacket* packet = av_packet_alloc();
  for (int i = 0; av_read_frame(in, packet) >= 0; ++i) {
    av_packet_make_writable(packet);
    changes.packet(*packet, i);
    packet->stream_index = 0;
    packet->pos = -1;
    av_packet_rescale_ts(packet, in->streams[0]->time_base, stream.time_base);
    ASSERT_GE(av_interleaved_write_frame(out, packet), 0);
  }
  av_packet_free(&packet);
  ASSERT_EQ(av_write_trailer(out), 0);
  avio_closep(&out->pb);
  avformat_free_context(out);
  avformat_close_input(&in);
}

inline void cut_to(const std::filesystem::path& file, double share) {
  const auto size = static_cast<double>(std::filesystem::file_size(file));
  std::filesystem::resize_file(file, static_cast<std::uintmax_t>(size * share));
}

}  // namespace graspdb::testing
