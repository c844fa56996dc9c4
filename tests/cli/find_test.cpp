// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "graspdb/database/database.h"
#include "graspdb/database/search.h"
#include "graspdb/features/hand_finder.h"
#include "graspdb/features/hand_follower.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/finding.h"
#include "graspdb/sequences/sequence.h"
#include "graspdb/tracker/hand_reader.h"
#include "program.h"
#include "support/temporary_directory.h"
#include "support/tripod_sequence.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run_program;

constexpr int kNoHandInAny = 3;  // the exit status

// Two frames of a hand before a grey wall, with the masks that the library finds.
class Find : public ::testing::Test {
 protected:
  void SetUp() override {
    SequenceSpec spec = testing::tripod_sequence();
    spec.keyframes.back().time = 0.1;
    const SequenceRenderer renderer(spec);
    fs::create_directories(directory_ / "frames");
    fs::create_directories(directory_ / "truth");
    for (int i = 0; i < 2; ++i) {
      const ColorImage color = renderer.render(i).color;
      const std::string name = "hand" + std::to_string(i) + ".png";
      write_png(directory_ / ("frames/" + name), color);
      found_.push_back(find_hand(color).hand);
      write_png(directory_ / ("truth/" + name), found_.back());
    }
  }
  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  testing::TemporaryDirectory directory_;
  std::vector<Mask> found_;
};

TEST_F(Find, MasksAreNamedAsThePictures) {
  const Outcome outcome =
      run_program("find " + path("frames") + " --finder redness --out " + path("masks"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("masks of 2 frames, 2 with a hand"));
  EXPECT_FALSE(is_empty(found_[1]));
  EXPECT_EQ(read_gray(directory_ / "masks/hand1.png"), found_[1]);
}

TEST_F(Find, TheLearnedFinderHasAName) {
  const std::string find = "find " + path("frames") + " --truth " + path("truth") + " --out ";
  const Outcome named = run_program(find + path("a") + " --finder hand");
  const Outcome file = run_program(find + path("b") + " --finder " + finder_file("hand").string());
  EXPECT_THAT(named.out, HasSubstr("2 with a hand"));
  EXPECT_EQ(read_gray(directory_ / "a/hand1.png"), read_gray(directory_ / "b/hand1.png"));
  EXPECT_GT(mask_iou(read_gray(directory_ / "a/hand1.png"), found_[1]), 0.7);
  EXPECT_EQ(file.code, 0) << file.err;
}

TEST_F(Find, ADatabaseChoosesBetweenNetAndColor) {
  ASSERT_EQ(testing::build_tiny(path("tiny.graspdb")).code, 0);
  const std::string find = "find " + path("frames") + " --out " + path("masks") + " --database ";
  const Outcome outcome = run_program(find + path("tiny.graspdb"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Database database = Database::open(path("tiny.graspdb"));
  const auto search = open_search(database, kDefaultSearch);
  HandFollower follower({.net = std::make_shared<HandFinder>(HandFinder::load(finder_file("hand"))),
                         .unlikeness = unlikeness_to(database, *search, Handedness::kAuto)});
  for (const std::string name : {"hand0.png", "hand1.png"}) {
    const Mask expected = follower.next(read_color(directory_ / ("frames/" + name))).hand;
    EXPECT_EQ(read_gray(directory_ / ("masks/" + name)), expected) << name;
  }
}

TEST_F(Find, ADatabaseHasNoChoiceBesideARuleOfColor) {
  const Outcome outcome = run_program("find " + path("frames") + " --out " + path("masks") +
                                      " --finder redness --database " + path("absent"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("'--database': expected a learned finder"));
}

TEST_F(Find, ADatabaseThatIsNoneIsToldBeforeAnyMask) {
  const Outcome outcome = run_program("find " + path("frames") + " --out " + path("masks") +
                                      " --database " + path("frames/hand0.png"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("hand0.png"));
  EXPECT_FALSE(fs::exists(directory_ / "masks"));
}

TEST_F(Find, TruthTellsHowWellMasksAgree) {
  const std::string find = "find " + path("frames") + " --finder redness --out " + path("masks") +
                           " --truth " + path("truth");
  EXPECT_THAT(run_program(find).out, HasSubstr("mean 1.000, worst 1.000 (hand0.png), of 2 hands"));
  // The second one is none, and of the first the upper half is missing.
  Mask half = found_[0];
  write_png(directory_ / "truth/hand1.png", Mask(half.width(), half.height()));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < half.size(); ++i) {
    if (i < half.size() / 2) half.data()[i] = 0;
    kept += half.data()[i] != 0;
  }
  write_png(directory_ / "truth/hand0.png", half);
  const auto all = static_cast<double>(std::ranges::count(found_[0], 255));
  const Outcome outcome = run_program(find);
  EXPECT_THAT(outcome.out, HasSubstr(fmt::format("mean {:.3f}", static_cast<double>(kept) / all)));
  EXPECT_THAT(outcome.out, HasSubstr("hands that were not found: 0; found where there is none: 1"));
}

TEST_F(Find, AFolderThatHoldsOtherFilesIsLeftAsItIs) {
  const Outcome outcome = run_program("find " + path("frames") + " --out " + path("truth"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("masks only"));
  EXPECT_TRUE(fs::exists(directory_ / "truth/hand0.png"));
}

TEST_F(Find, HandsThatAreNotFoundAreCounted) {
  fs::create_directories(directory_ / "walls");
  write_png(directory_ / "walls/hand0.png",
            ColorImage(found_[0].width(), found_[0].height(), {200, 120, 60}));
  const Outcome outcome = run_program("find " + path("walls") + " --out " + path("masks") +
                                      " --truth " + path("truth"));
  EXPECT_THAT(outcome.out, HasSubstr("worst 0.000 (hand0.png)"));
  EXPECT_THAT(outcome.out, HasSubstr("hands that were not found: 1;"));
}

TEST_F(Find, WhatIsReadIsNotWrittenOver) {
  const std::string find = "find " + path("frames") + " --out " + path("masks");
  ASSERT_EQ(run_program(find).code, 0);
  const Outcome outcome = run_program(find + " --truth " + path("masks"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is read from"));
  EXPECT_TRUE(fs::exists(directory_ / "masks/hand0.png"));
}

TEST_F(Find, APictureWithoutAHandIsToldByTheExitStatus) {
  write_png(directory_ / "wall.png", ColorImage(160, 120, {200, 120, 60}));
  const Outcome outcome = run_program("find " + path("wall.png") + " --out " + path("masks"));
  EXPECT_EQ(outcome.code, kNoHandInAny) << outcome.err;
  EXPECT_TRUE(fs::exists(directory_ / "masks/wall.png"));
}

TEST_F(Find, TwoPicturesOfOneNameAreRefused) {
  fs::copy_file(directory_ / "frames/hand0.png", directory_ / "frames/hand0.bmp");
  const Outcome outcome = run_program("find " + path("frames") + " --out " + path("masks"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("hand0.png"));
}

}  // namespace
}  // namespace graspdb
