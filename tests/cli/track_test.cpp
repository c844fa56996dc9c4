// SPDX-License-Identifier: MIT
// track: what it writes, what it refuses, and that nothing is left under a final name when it
// fails.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/videoio.hpp>
#include <sstream>
#include <thread>

#include "graspdb/core/file.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/sequence.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lines_of;
using testing::Outcome;
using testing::run_program;
using ::testing::SizeIs;
using ::testing::StartsWith;

struct Size {
  int width = 0, height = 0;
};

// A ball of skin colour; its mask stands for a hand.
void write_frame(const fs::path& folder, const std::string& name, const Size& size,
                 const Size& mask_size) {
  ColorImage color(size.width, size.height, {90, 60, 40});
  Mask mask(mask_size.width, mask_size.height);
  for (int y = 20; y < 60; ++y) {
    for (int x = 20; x < 60; ++x) {
      color.at(x, y) = {110, 140, static_cast<std::uint8_t>(160 + x)};
      mask.at(x, y) = 255;
    }
  }
  fs::create_directories(folder / "frames");
  fs::create_directories(folder / "masks");
  write_png(folder / "frames" / (name + ".png"), color);
  write_png(folder / "masks" / (name + ".png"), mask);
}

std::vector<json> json_lines(const fs::path& file) {
  std::vector<json> lines;
  std::istringstream text(read_text(file));
  for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
  return lines;
}

class Track : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = std::make_unique<testing::TemporaryDirectory>();
    ASSERT_EQ(testing::build_tiny(*shared_ / "tiny.graspdb").code, 0);
  }
  static void TearDownTestSuite() { shared_.reset(); }

  static std::string database() { return (*shared_ / "tiny.graspdb").string(); }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  // Any descriptor is near enough.
  std::string frames_with_masks() const {
    return database() + " " + path("frames") + " --masks " + path("masks") + " --max-distance 1000";
  }
  Outcome track(const std::string& arguments) const { return run_program("track " + arguments); }

  // One clear line, and nothing of the answer.
  void expect_refused(const std::string& arguments, const std::string& told) const {
    const Outcome outcome =
        track(arguments + " --json " + path("answer.jsonl") + " --video " + path("answer.mp4"));
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    const auto line = outcome.err.substr(outcome.err.find("graspdb: "));
    EXPECT_EQ(lines_of(line), 1) << outcome.err;
    EXPECT_THAT(line, HasSubstr(told));
    for (const auto& entry : fs::directory_iterator(directory_.path()))
      EXPECT_THAT(entry.path().filename().string(), ::testing::Not(StartsWith("answer")));
  }

  static std::unique_ptr<testing::TemporaryDirectory> shared_;
  testing::TemporaryDirectory directory_;
};
std::unique_ptr<testing::TemporaryDirectory> Track::shared_;

TEST_F(Track, AnswersOnStandardOutputStandThereAlone) {
  write_frame(directory_.path(), "f1", {160, 90}, {160, 90});
  const Outcome outcome = track(frames_with_masks() + " --json -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(lines_of(outcome.out), 1) << outcome.out;
  EXPECT_EQ(json::parse(outcome.out).at("frame"), 0);
  EXPECT_THAT(outcome.err, HasSubstr("1 frames, 1 with a hand"));
}

TEST_F(Track, WritesALineAFrameAndAVideo) {
  for (const char* name : {"f1", "f2", "f10"})  // the last would come second by letters
    write_frame(directory_.path(), name, {name == std::string("f10") ? 120 : 160, 90},
                {name == std::string("f10") ? 120 : 160, 90});
  const Outcome outcome = track(frames_with_masks() + " --handedness left --json " +
                                path("new/answer.jsonl") + " --video " + path("made/answer.mp4"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("3 frames, 3 with a hand"));
  EXPECT_THAT(outcome.err, HasSubstr("--focal"));
  // The tiny database holds its object in every row, and has one forearm: told once.
  EXPECT_THAT(outcome.err, HasSubstr("no hands without objects"));
  EXPECT_THAT(outcome.err, HasSubstr("one length of forearm"));
  EXPECT_THAT(outcome.err, HasSubstr("no codes of a learned descriptor"));
  EXPECT_EQ(outcome.err.find("--preset tracking"), outcome.err.rfind("--preset tracking"));
  const std::vector<json> lines = json_lines(directory_ / "new/answer.jsonl");
  ASSERT_THAT(lines, SizeIs(3));
  for (const char* key :
       {"frame", "time_s", "valid", "confidence", "box", "ms", "row", "distance", "grasp", "step",
        "camera_from_hand", "wrist_m", "angles", "joints_m", "joints_px", "hypotheses"})
    EXPECT_TRUE(lines[0].contains(key)) << key;
  EXPECT_EQ(lines[0].at("box"), json({20, 20, 40, 40}));
  EXPECT_EQ(lines[0].at("grasp").at("id"), 9);
  EXPECT_THAT(lines[0].at("joints_m"), SizeIs(21));
  // f10 comes last and is narrower: its guessed camera sees the same box further to the right, so
  // that the wrist is elsewhere.
  EXPECT_EQ(lines[0].at("wrist_m"), lines[1].at("wrist_m"));
  EXPECT_NE(lines[1].at("wrist_m"), lines[2].at("wrist_m"));
  cv::VideoCapture video(path("made/answer.mp4"), cv::CAP_FFMPEG);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), 3);
  const Outcome again = track(database() + " " + path("made/answer.mp4"));
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("3 frames"));
}

TEST_F(Track, ExplainsEachFrameWithTheRowsThatWereWeighed) {
  write_frame(directory_.path(), "hand", {160, 90}, {160, 90});
  write_frame(directory_.path(), "none", {160, 90}, {160, 90});
  write_png(directory_ / "masks/none.png", Mask(160, 90));
  const auto page = [&](const std::string& name) {
    return read_color(directory_ / "steps" / (name + ".png"));
  };
  const std::string explain = " --explain " + path("steps");
  ASSERT_EQ(track(frames_with_masks() + explain).code, 0);
  const ColorImage answered = page("hand"), empty = page("none");
  EXPECT_GT(answered.height(), empty.height());  // there are no rows
  EXPECT_EQ(track(database() + " " + path("frames") + " --masks " + path("masks") + explain +
                  " --max-distance 0.01")
                .code,
            3);
  EXPECT_EQ(page("hand").height(), answered.height());  // the nearest row
  EXPECT_NE(page("hand"), answered);
  EXPECT_EQ(page("none"), empty);
}

// Its configuration is none of `graspdb build`: what it lacks for tracking is not known.
TEST_F(Track, ADatabaseThatNoBuildMadeIsReadAllTheSame) {
  write_frame(directory_.path(), "f1", {160, 90}, {160, 90});
  const Outcome outcome =
      track(GRASPDB_SOURCE_DIR "/tests/database/golden/v1.graspdb " + path("frames") + " --masks " +
            path("masks") + " --max-distance 1000");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("1 frames"));
  EXPECT_EQ(outcome.err.find("--preset tracking"), std::string::npos);
}

TEST_F(Track, InputsThatCannotBeReadAreNamed) {
  expect_refused(database() + " " + path("none.mp4"), path("none.mp4"));
  fs::create_directories(path("empty"));
  expect_refused(database() + " " + path("empty"), path("empty"));
  write_text(path("text.mp4"), "this is no video");
  expect_refused(database() + " " + path("text.mp4"), path("text.mp4"));
  write_text(path("text.graspdb"), "this is no database");
  expect_refused(path("text.graspdb") + " " + path("empty"), "");
  write_frame(directory_.path(), "f1", {160, 90}, {80, 90});
  expect_refused(frames_with_masks(), "a mask of 160 x 90 pixels");
}

// A folder as `graspdb sequence` writes it, of one frame.
void write_small_sequence(const fs::path& folder, double focal_px, int truth_lines) {
  write_frame(folder, "000000", {160, 90}, {160, 90});
  write_text(folder / "sequence.json", json{{"frames_per_second", 10},
                                            {"camera",
                                             {{"width_px", 160},
                                              {"height_px", 90},
                                              {"fx_px", focal_px},
                                              {"fy_px", focal_px},
                                              {"cx_px", 79.5},
                                              {"cy_px", 44.5}}}}
                                           .dump());
  const json truth = {{"time_s", 0},
                      {"closure", 0},
                      {"camera_from_hand", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
                      {"wrist_m", {0, 0, 0.5}},
                      {"angles", std::vector<double>(JointAngles::SizeAtCompileTime)},
                      {"joints_m", std::vector<double>(std::size_t{3} * kKeypointCount)}};
  std::string lines;
  for (int i = 0; i < truth_lines; ++i) lines += truth.dump() + "\n";
  write_text(folder / "truth.jsonl", lines);
}

TEST_F(Track, ARenderedSequenceMustFitItsTruthAndCamera) {
  const std::string masks = " --masks " + path("masks") + " --max-distance 1000";
  write_small_sequence(directory_.path(), 150, 1);
  const Outcome outcome = track(database() + " " + directory_.path().string() + masks);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("oracle"));
  const Outcome focal = track(database() + " " + directory_.path().string() + " --focal 900");
  EXPECT_EQ(focal.code, 2);
  EXPECT_THAT(focal.err, HasSubstr("--focal"));
  write_small_sequence(directory_.path(), 150, 2);
  expect_refused(database() + " " + directory_.path().string() + masks, "truth.jsonl");
  write_small_sequence(directory_.path(), 0, 1);
  expect_refused(database() + " " + directory_.path().string() + masks, "fx_px");
  write_small_sequence(directory_.path(), 150, 1);
  write_frame(directory_.path(), "000000", {100, 90}, {100, 90});
  expect_refused(database() + " " + directory_.path().string() + masks, "160 x 90");
}

// Whether some JSON was written aside by now.
bool has_started(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("answer.jsonl.") && fs::file_size(entry.path()) > 0) return true;
  }
  return false;
}

pid_t start_tracking(const std::string& database, const std::string& frames,
                     const std::string& masks, const std::string& answer) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(GRASPDB_PROGRAM, "graspdb", "track", database.c_str(), frames.c_str(), "--masks",
            masks.c_str(), "--json", answer.c_str(), "--max-distance", "1000", nullptr);
    ::_exit(127);
  }
  return child;
}

TEST_F(Track, AnInterruptKeepsWhatWasTracked) {
  constexpr int kFrames = 20000;
  write_frame(directory_.path(), "f", {160, 90}, {160, 90});
  for (int i = 0; i < kFrames; ++i) {
    for (const char* folder : {"frames", "masks"})
      fs::create_symlink("f.png", directory_ / folder / (std::to_string(i) + ".png"));
  }
  const pid_t child =
      start_tracking(database(), path("frames"), path("masks"), path("answer.jsonl"));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!has_started(directory_.path()) && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ::kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  const auto lines = json_lines(directory_ / "answer.jsonl");
  EXPECT_GT(lines.size(), 0u);
  EXPECT_LT(lines.size(), static_cast<std::size_t>(kFrames));
}

}  // namespace
}  // namespace graspdb
