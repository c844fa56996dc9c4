// SPDX-License-Identifier: MIT
// A video's frames are those that a player shows, at the times at which it shows them.
#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/video/frame_source.h"
#include "support/quarters.h"
#include "support/temporary_directory.h"
#include "support/videos.h"

namespace graspdb {
namespace {

using ::testing::Contains;
using testing::corners_of;
using testing::cut_to;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::write_again;
using testing::write_video;

struct Shown {
  std::vector<InputFrame> frames;
  std::vector<std::string> warnings;
};

Shown shown(const std::filesystem::path& file) {
  const auto source = open_source(file.string(), {});
  Shown all;
  while (auto frame = source->next()) all.frames.push_back(std::move(*frame));
  all.warnings = source->warnings();
  return all;
}

class VideoFile : public ::testing::Test {
 protected:
  std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  testing::TemporaryDirectory directory_;
};

// [a b . c d . x y .] in 16.16: the stored pixel (u, v) is shown at (a u + c v, b u + d v).
void set_matrix(AVStream& stream, int a, int b, int c, int d) {
  constexpr int kOne = 1 << 16;
  const std::array<std::int32_t, 9> matrix = {a * kOne, b * kOne, 0, c * kOne, d * kOne,
                                              0,        0,        0, 1 << 30};
  std::uint8_t* data = av_stream_new_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, sizeof(matrix));
  std::memcpy(data, matrix.data(), sizeof(matrix));
}

TEST_F(VideoFile, FramesAreTurnedAndMirroredAsTheDisplayMatrixSays) {
  write_video(path("stored.mp4"), 3);
  struct Turn {
    int a, b, c, d;
    std::string corners;
  };
  for (const Turn& turn :
       {Turn{0, 1, -1, 0, "brwg"}, Turn{-1, 0, 0, -1, "wbgr"}, Turn{0, -1, 1, 0, "gwrb"},
        Turn{-1, 0, 0, 1, "grwb"}, Turn{1, 0, 0, -1, "bwrg"}, Turn{0, 1, 1, 0, "rbgw"},
        Turn{0, -1, -1, 0, "wgbr"}, Turn{1, 0, 0, 1, "rgbw"}}) {
    write_again(path("stored.mp4"), path("turned.mp4"),
                {.stream = [&](AVStream& s) { set_matrix(s, turn.a, turn.b, turn.c, turn.d); }});
    const Shown video = shown(path("turned.mp4"));
    ASSERT_EQ(video.frames.size(), 3u);
    for (const InputFrame& frame : video.frames) EXPECT_EQ(corners_of(frame.color), turn.corners);
    EXPECT_EQ(video.frames[0].color.width(), turn.b == 0 ? 64 : 32);
    EXPECT_EQ(video.frames[0].notes.empty(), turn.corners == "rgbw");
    EXPECT_THAT(video.frames[1].notes, IsEmpty());  // said once
  }
}

TEST_F(VideoFile, ATurnByNoQuarterIsSaidNotGuessed) {
  write_video(path("stored.mp4"), 1);
  write_again(path("stored.mp4"), path("turned.mp4"),
              {.stream = [](AVStream& stream) { set_matrix(stream, 1, 1, -1, 1); }});
  const Shown video = shown(path("turned.mp4"));
  EXPECT_EQ(corners_of(video.frames.at(0).color), "rgbw");
  EXPECT_THAT(video.frames[0].notes, ElementsAre(HasSubstr("45 degrees")));
}

// The frames lie in the file in another order than they are shown in, and some are late.
TEST_F(VideoFile, EveryFrameHasItsOwnTime) {
  constexpr int kFrames = 20, kLate = 10;
  write_video(path("even.mp4"), kFrames, "avc1");
  std::int64_t frame = 0;
  write_again(path("even.mp4"), path("late.mp4"),
              {.stream = [&](AVStream& s) { frame = s.time_base.den / s.time_base.num / 10; },
               .packet =
                   [&](AVPacket& packet, int) {
                     for (std::int64_t* ticks : {&packet.pts, &packet.dts})
                       *ticks += 9 * std::max<std::int64_t>(0, *ticks - kLate * frame);
                   }});
  const Shown video = shown(path("late.mp4"));
  ASSERT_EQ(video.frames.size(), static_cast<std::size_t>(kFrames));
  for (int i = 0; i < kFrames; ++i)
    EXPECT_NEAR(video.frames[i].time, i <= kLate ? 0.1 * i : 1.0 + (i - kLate), 1e-3) << i;
  EXPECT_THAT(video.warnings, IsEmpty());
}

TEST_F(VideoFile, PixelsAreMadeSquare) {
  write_video(path("stored.mp4"), 1);
  write_again(path("stored.mp4"), path("wide.mp4"), {.stream = [](AVStream& stream) {
                stream.sample_aspect_ratio = {2, 1};
              }});
  const Shown video = shown(path("wide.mp4"));
  EXPECT_EQ(video.frames.at(0).color.width(), 128);
  EXPECT_EQ(video.frames[0].color.height(), 32);
  EXPECT_EQ(corners_of(video.frames[0].color), "rgbw");
  EXPECT_THAT(video.frames[0].notes, ElementsAre(HasSubstr("square pixels")));
}

TEST_F(VideoFile, AFileThatEndsEarlyIsReadAsFarAsItGoesAndSaysSo) {
  constexpr std::size_t kFrames = 60;
  for (const auto& [name, codec] :
       {std::pair("a.mp4", "mp4v"), std::pair("b.mp4", "avc1"), std::pair("a.mov", "MJPG"),
        std::pair("a.avi", "MJPG"), std::pair("a.mkv", "mp4v"), std::pair("b.mkv", "avc1")}) {
    const bool is_avi = path(name).extension() == ".avi";
    write_video(path(is_avi ? name : "stored.mov"), kFrames, codec);
    if (!is_avi) write_again(path("stored.mov"), path(name), {});
    const Shown whole = shown(path(name));
    EXPECT_EQ(whole.frames.size(), kFrames) << name;
    EXPECT_THAT(whole.warnings, IsEmpty()) << name;
    cut_to(path(name), 0.6);
    const Shown part = shown(path(name));
    EXPECT_GT(part.frames.size(), kFrames / 10) << name;
    EXPECT_LT(part.frames.size(), kFrames * 4 / 5) << name;
    EXPECT_THAT(part.warnings, Contains(HasSubstr("ends early"))) << name;
  }
}

TEST_F(VideoFile, WhatFollowsADamagedFrameIsRead) {
  write_video(path("whole.avi"), 30, "MJPG");
  write_again(path("whole.avi"), path("damaged.mov"), {.packet = [](AVPacket& packet, int i) {
                if (i == 10) std::memset(packet.data, 0, static_cast<std::size_t>(packet.size));
              }});
  const Shown video = shown(path("damaged.mov"));
  EXPECT_EQ(video.frames.size(), 29u);
  EXPECT_NEAR(video.frames.back().time, 2.9, 1e-3);
  EXPECT_THAT(video.warnings, ElementsAre("damaged packets or frames: 1"));
}

TEST_F(VideoFile, WhatIsNoVideoIsNamed) {
  write_text(path("text.mp4"), "no video");
  write_text(path("list.m3u8"), "#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:1/a.ts\n#EXT-X-ENDLIST\n");
  cv::imwrite(path("photo.png").string(), cv::Mat(20, 20, CV_8UC3));
  std::filesystem::rename(path("photo.png"), path("photo.other"));  // its EXIF would be lost
  for (const char* name : {"text.mp4", "list.m3u8", "absent.mp4", "photo.other"}) {
    try {
      shown(path(name));
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(name));
    }
  }
}

}  // namespace
}  // namespace graspdb
