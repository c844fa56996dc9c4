// SPDX-License-Identifier: MIT
// track and query say what they did to what came in, and what was wrong with it.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "graspdb/core/file.h"
#include "graspdb/renderer/image_io.h"
#include "program.h"
#include "support/temporary_directory.h"
#include "support/videos.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run_program;

constexpr int kNothingFound = 3;  // the exit status

// A block of skin on the left of a blue wall, 160 x 90 pixels.
ColorImage block_of_skin() {
  ColorImage color(160, 90, {90, 60, 40});
  for (int y = 20; y < 60; ++y) {
    for (int x = 20; x < 60; ++x) color.at(x, y) = {110, 140, static_cast<std::uint8_t>(160 + x)};
  }
  return color;
}

Mask mask_of_block(std::uint8_t hand) {
  Mask mask(160, 90);
  for (int y = 20; y < 60; ++y) std::fill_n(&mask.at(20, y), 40, hand);
  return mask;
}

// Stored turned by a quarter, with the orientation that turns it upright.
void write_turned(const fs::path& file, const ColorImage& upright) {
  const fs::path plain = fs::path(file).replace_extension(".upright.png");
  write_png(plain, upright);
  OIIO::ImageBuf stored = OIIO::ImageBufAlgo::rotate270(OIIO::ImageBuf(plain.string()));
  stored.specmod()["Orientation"] = 6;
  ASSERT_TRUE(stored.write(file.string())) << stored.geterror();
  fs::remove(plain);
}

class TrackMedia : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<testing::TemporaryDirectory>();
    ASSERT_EQ(testing::build_tiny(*shared_ / "tiny.graspdb").code, 0);
  }
  static void TearDownTestSuite() { shared_.reset(); }

  void SetUp() override {
    fs::create_directories(directory_ / "frames");
    fs::create_directories(directory_ / "masks");
  }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  // Any descriptor is near enough.
  Outcome track(const std::string& arguments) const {
    return run_program("track " + database() + " " + arguments + " --max-distance 1000 --json " +
                       path("answer.jsonl"));
  }
  Outcome track_frames() const { return track(path("frames") + " --masks " + path("masks")); }
  Outcome query(const std::string& arguments) const {
    return run_program("query " + database() + " -k 1 --json " + arguments);
  }
  std::vector<json> answers() const {
    std::vector<json> lines;
    std::istringstream text(read_text(directory_ / "answer.jsonl"));
    for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
    return lines;
  }
  std::string last_warnings() const { return answers().back().value("warnings", json()).dump(); }

  static std::string database() { return (*shared_ / "tiny.graspdb").string(); }
  static inline std::unique_ptr<testing::TemporaryDirectory> shared_;
  testing::TemporaryDirectory directory_;
};

TEST_F(TrackMedia, ATurnedPhotographIsReadUprightAndSaysSo) {
  for (const char* name : {"a", "b"}) {
    write_turned(path("frames/" + std::string(name) + ".tif"), block_of_skin());
    write_png(path("masks/" + std::string(name) + ".png"), mask_of_block(255));
  }
  const Outcome outcome = track_frames();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("frame 0: turned clockwise by 90 degrees"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("frame 1")));
  for (const json& line : answers()) {
    EXPECT_EQ(line.at("box"), json({20, 20, 40, 40}));
    EXPECT_THAT(line.at("notes").dump(), HasSubstr("EXIF orientation 6"));
  }
  EXPECT_EQ(answers().at(1).at("file"), "b.tif");
  const Outcome found = query(path("frames/a.tif") + " --mask " + path("masks/a.png"));
  ASSERT_EQ(found.code, 0) << found.err;
  EXPECT_THAT(found.err, HasSubstr("a.tif: turned clockwise"));
  EXPECT_EQ(json::parse(found.out).at("box"), json({20, 20, 40, 40}));
  EXPECT_THAT(json::parse(found.out).at("notes").dump(), HasSubstr("EXIF orientation 6"));
}

TEST_F(TrackMedia, AVideoThatEndsEarlySaysSoWithItsLastFrame) {
  testing::write_video(path("stored.mp4"), 40);
  testing::write_again(path("stored.mp4"), path("a.mp4"), {});
  testing::cut_to(path("a.mp4"), 0.6);
  const Outcome outcome = track(path("a.mp4"));
  EXPECT_THAT(outcome.err, HasSubstr("warning: the file ends early"));
  EXPECT_GT(answers().size(), 5u);
  EXPECT_FALSE(answers().front().contains("warnings"));
  EXPECT_THAT(last_warnings(), HasSubstr("of the 40 frames that it announces"));
}

TEST_F(TrackMedia, MasksOfOneAndOfLabelsAreReadAsThoseOf255) {
  write_png(path("frames/a.png"), block_of_skin());
  Mask labels = mask_of_block(1);
  for (int x = 0; x < 20; ++x) labels.at(x, 5) = 2;
  for (const Mask& mask : {mask_of_block(255), mask_of_block(1), labels}) {
    write_png(path("masks/a.png"), mask);
    EXPECT_EQ(track_frames().code, 0);
    EXPECT_EQ(answers().at(0).at("box"), json({20, 20, 40, 40}));
    const Outcome found = query(path("frames/a.png") + " --mask " + path("masks/a.png"));
    EXPECT_EQ(json::parse(found.out).at("box"), json({20, 20, 40, 40}));
  }
  labels.at(0, 0) = 4;
  write_png(path("masks/a.png"), labels);
  const Outcome refused = track_frames();
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("masks/a.png"));
}

TEST_F(TrackMedia, ThePictureSaysWhichCameraIsTaken) {
  write_png(path("frames/a.png"), block_of_skin());
  write_png(path("masks/a.png"), mask_of_block(255));
  const auto camera = [&](const std::string& options) {
    const Outcome outcome = track(path("frames") + " --masks " + path("masks") + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return answers().at(0).at("camera");
  };
  EXPECT_EQ(camera("").at("from"), "guess");
  const json stated = camera(" --focal 300 --principal 10,20");
  EXPECT_EQ(stated.at("from"), "--focal");
  EXPECT_EQ(stated.at("fx_px"), 300);
  EXPECT_EQ(stated.at("cx_px"), 10);
  write_text(path("k.txt"), "300 0 40 0 310 50 0 0 1");
  const json calibrated = camera(" --camera " + path("k.txt"));
  EXPECT_EQ(calibrated.at("from"), "calibration");
  EXPECT_EQ(calibrated.at("fy_px"), 310);
}

TEST_F(TrackMedia, BlackMasksAreNoHandAndTheRunSaysSo) {
  write_png(path("frames/a.png"), block_of_skin());
  write_png(path("masks/a.png"), mask_of_block(0));
  write_png(path("frames/b.png"), block_of_skin());
  write_png(path("masks/b.png"), mask_of_block(0));
  Outcome outcome = track_frames();
  EXPECT_EQ(outcome.code, kNothingFound);
  EXPECT_THAT(outcome.err, HasSubstr("no hand in any of 2 frames"));
  EXPECT_FALSE(answers().at(0).contains("warnings"));
  EXPECT_EQ(answers().at(0).at("why"), "nothing in the frame looks like a hand");
  EXPECT_THAT(last_warnings(), HasSubstr("no hand in any of 2 frames"));
  write_png(path("masks/b.png"), mask_of_block(255));
  outcome = track_frames();
  EXPECT_EQ(outcome.code, 0) << outcome.err;  // a frame without a hand among others is none
  EXPECT_THAT(outcome.err, Not(HasSubstr("no hand in")));
}

TEST_F(TrackMedia, WithoutColorAMaskIsAskedFor) {
  ColorImage gray = block_of_skin();
  for (Bgr& pixel : gray) pixel = {pixel[2], pixel[2], pixel[2]};
  write_png(path("frames/a.png"), gray);
  write_png(path("masks/a.png"), mask_of_block(255));
  const Outcome outcome = track(path("frames") + " --finder redness");
  EXPECT_EQ(outcome.code, kNothingFound);
  EXPECT_THAT(outcome.err, HasSubstr("no colour"));
  EXPECT_THAT(last_warnings(), HasSubstr("no colour"));
  const Outcome nothing = query(path("frames/a.png") + " --finder redness");
  EXPECT_EQ(nothing.code, 1);
  EXPECT_THAT(nothing.err, HasSubstr("without colour"));
  EXPECT_EQ(track_frames().code, 0);
  EXPECT_EQ(last_warnings(), "null");
}

}  // namespace
}  // namespace graspdb
