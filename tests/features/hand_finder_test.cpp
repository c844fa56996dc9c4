// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_finder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "features/color_finder.h"
#include "features/net_bytes.h"
#include "features/net_fault.h"
#include "features/pictures.h"
#include "features/plain_layer.h"
#include "graspdb/core/error.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

using testing::area;
using testing::color_finder;
using testing::Cube;
using testing::expect_refused;
using testing::finder_file;
using testing::kBlue;
using testing::kGreen;
using testing::kRed;
using testing::NetFault;
using testing::NetFile;
using testing::NetLayer;
using testing::paint;
using testing::plain_join;
using testing::plain_layer;
using testing::random_layer;
using testing::small_finder;

ColorImage random_frame(int width, int height, std::uint64_t seed) {
  RandomStream random(seed);
  ColorImage frame(width, height);
  for (Bgr& pixel : frame) {
    for (std::uint8_t& color : pixel) color = static_cast<std::uint8_t>(random.below(256));
  }
  return frame;
}

Box whole(const ColorImage& frame) {
  return {0, 0, frame.width(), frame.height()};
}

// The last result of the net, number by number.
Cube plain_scores(const NetFile& file, const ColorImage& frame) {
  Cube cube{
      static_cast<std::size_t>(frame.width()), static_cast<std::size_t>(frame.height()), 3, {}};
  for (const Bgr& pixel : frame) cube.values.insert(cube.values.end(), pixel.begin(), pixel.end());
  std::vector<Cube> results;
  for (const NetLayer& layer : file.layers) {
    if (layer.beside) cube = plain_join(cube, results[*layer.beside]);
    cube = plain_layer(layer, cube, &layer == &file.layers.back());
    results.push_back(cube);
  }
  return cube;
}

PartCells plain_lead(const Cube& scores, std::size_t part) {
  PartCells cells(static_cast<int>(scores.width), static_cast<int>(scores.height));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::int64_t other = -1'000'000'000;
    for (std::size_t c = 0; c < 4; ++c) {
      if (c != part) other = std::max(other, scores.values[4 * i + c]);
    }
    const double lead = static_cast<double>(scores.values[4 * i + part] - other);
    cells.data()[i] = static_cast<std::uint8_t>(std::clamp(128 + std::floor(lead / 2), 0., 255.));
  }
  return cells;
}

class EachInstructionSetFinds : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(HandFinder, EachInstructionSetFinds, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(EachInstructionSetFinds, WhatThePlainSumsSay) {
  use_param();
  for (const auto& [width, height] : {std::pair{37, 23}, {24, 40}, {1, 1}}) {
    const NetFile file = small_finder(3);
    const ColorImage frame = random_frame(width, height, 5);
    const FrameParts parts = HandFinder::parse(file.bytes(), "net").look(frame, whole(frame));
    const Cube scores = plain_scores(file, frame);
    EXPECT_EQ(parts.cell_px, 2);
    EXPECT_EQ(parts.hand, plain_lead(scores, 1));
    EXPECT_EQ(parts.arm, plain_lead(scores, 2));
    EXPECT_EQ(parts.object, plain_lead(scores, 3));
  }
  use_best();
}

TEST(HandFinder, AnyLayerMayBeReadAgain) {
  RandomStream random(8);
  NetFile file =
      finder_file({random_layer(4, 3, 3, 1, 1, random), random_layer(4, 3, 4, 2, 1, random),
                   random_layer(4, 3, 4, 2, 1, random), random_layer(4, 3, 8, 1, 1, random),
                   random_layer(4, 3, 8, 1, 1, random)});
  file.layers[3].beside = 1;
  file.layers[4].beside = 0;
  const ColorImage frame = random_frame(19, 14, 2);
  const FrameParts parts = HandFinder::parse(file.bytes(), "net").look(frame, whole(frame));
  EXPECT_EQ(parts.cell_px, 1);
  EXPECT_EQ(parts.hand, plain_lead(plain_scores(file, frame), 1));
}

// The frame with every pixel as often as `times` says, in both directions.
ColorImage enlarged(const ColorImage& frame, int times) {
  ColorImage large(times * frame.width(), times * frame.height());
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) large.at(x, y) = frame.at(x / times, y / times);
  }
  return large;
}

TEST(HandFinder, ALargeFrameIsLookedAtMadeSmall) {
  const HandFinder finder = HandFinder::parse(small_finder(1).bytes(), "net");
  const ColorImage small = random_frame(160, 120, 4), large = enlarged(small, 4);
  const FrameParts seen = finder.look(large, whole(large));
  EXPECT_EQ(seen.cell_px, 8);
  EXPECT_EQ(seen.hand, finder.look(small, whole(small)).hand);
}

TEST(HandFinder, NothingBeyondTheWindowMatters) {
  const HandFinder finder = HandFinder::parse(small_finder(1).bytes(), "net");
  const ColorImage frame = random_frame(90, 70, 4);
  const Box window{11, 5, 40, 30};
  ColorImage part(window.width, window.height);
  for (int y = 0; y < window.height; ++y) {
    std::copy_n(frame.row(window.y + y) + window.x, window.width, part.row(y));
  }
  EXPECT_EQ(finder.look(frame, window).hand, finder.look(part, whole(part)).hand);
}

bool is_hand(const FoundHand& found, const Box& box) {
  return found.hand.at(box.x + box.width / 2, box.y + box.height / 2) != 0;
}

constexpr Box kPalm{40, 30, 30, 40}, kThumb{90, 45, 10, 8};

TEST(HandFinder, FindsAHandToThePixel) {
  ColorImage frame(160, 120);
  paint(frame, kPalm, kRed);
  const auto found = color_finder().find(frame);
  ASSERT_TRUE(found);
  EXPECT_EQ(area(found->hand), kPalm.width * kPalm.height);
  EXPECT_TRUE(is_hand(*found, kPalm));
  EXPECT_EQ(area(found->arm), 0);
}

TEST(HandFinder, FindsNoneInAnEmptyRoom) {
  ColorImage frame(160, 120);
  EXPECT_FALSE(color_finder().find(frame));
  paint(frame, {20, 20, 50, 50}, kBlue);
  paint(frame, {80, 20, 50, 50}, kGreen);
  EXPECT_FALSE(color_finder().find(frame));
  paint(frame, {140, 100, 3, 3}, kRed);
  EXPECT_FALSE(color_finder().find(frame)) << "a speck is no hand";
}

TEST(HandFinder, WhatAHeldObjectCutsOffBelongsToTheHand) {
  ColorImage frame(160, 120);
  const Box tip{151, 45, 8, 8};
  paint(frame, kPalm, kRed);
  paint(frame, tip, kRed);
  EXPECT_FALSE(is_hand(*color_finder().find(frame), tip));
  paint(frame, {kPalm.x + kPalm.width, 40, tip.x - kPalm.x - kPalm.width, 20}, kBlue);
  EXPECT_TRUE(is_hand(*color_finder().find(frame), tip));
}

TEST(HandFinder, PiecesNearbyBelongToTheHandUnlessTheyHaveAnArmOfTheirOwn) {
  ColorImage frame(160, 120);
  paint(frame, kPalm, kRed);
  paint(frame, kThumb, kRed);
  const Box far{150, 45, 8, 8}, arm{92, 53, 6, 67};
  paint(frame, far, kRed);
  EXPECT_TRUE(is_hand(*color_finder().find(frame), kThumb));
  EXPECT_FALSE(is_hand(*color_finder().find(frame), far));
  paint(frame, arm, kGreen);
  EXPECT_TRUE(is_hand(*color_finder().find(frame), kThumb)) << "it may be the palm's";
  paint(frame, {50, 70, 12, 50}, kGreen);
  EXPECT_FALSE(is_hand(*color_finder().find(frame), kThumb));
}

TEST(HandFinder, AGapAsNarrowAsALineCutsNothingOff) {
  ColorImage frame(160, 120);
  paint(frame, kPalm, kRed);
  const Box beside{kPalm.x + kPalm.width + 2, 45, 10, 8};
  paint(frame, beside, kRed);
  EXPECT_TRUE(is_hand(*color_finder().find(frame), beside));
}

TEST(HandFinder, OfTwoHandsTheLargerIsFoundUnlessARegionIsAskedFor) {
  ColorImage frame(160, 120);
  const Box other{110, 70, 20, 30};
  for (const Box& hand : {kPalm, other}) {
    paint(frame, hand, kRed);
    paint(frame, {hand.x, hand.y + hand.height, hand.width, 10}, kGreen);
  }
  const HandFinder finder = color_finder();
  EXPECT_TRUE(is_hand(*finder.find(frame), kPalm));
  EXPECT_FALSE(is_hand(*finder.find(frame), other));
  const auto asked = finder.find(frame, Box{100, 60, 20, 20});
  EXPECT_TRUE(is_hand(*asked, other));
  EXPECT_FALSE(is_hand(*asked, kPalm));
  EXPECT_FALSE(finder.find(frame, Box{0, 0, 10, 10}));
}

TEST(HandFinder, TellsTheArmThatTouchesTheHand) {
  ColorImage frame(160, 120);
  const Box own{50, 70, 12, 50}, other{120, 20, 12, 100};
  paint(frame, kPalm, kRed);
  paint(frame, own, kGreen);
  paint(frame, other, kGreen);
  const auto found = color_finder().find(frame);
  EXPECT_EQ(area(found->arm), own.width * own.height);
  EXPECT_EQ(found->arm.at(55, 100), 255);
}

TEST(HandFinder, LooksAtASmallHandOnceMore) {
  ColorImage frame(640, 480);
  const Box fine{301, 203, 61, 83};  // no multiples of 4, the factor of the whole frame
  paint(frame, fine, kRed);
  const auto found = color_finder().find(frame);
  ASSERT_TRUE(found);
  EXPECT_EQ(area(found->hand), fine.width * fine.height);
}

class FaultyFinder : public ::testing::TestWithParam<NetFault> {};

TEST_P(FaultyFinder, IsRefusedByName) {
  expect_refused(GetParam(), small_finder(4), HandFinder::parse);
}

INSTANTIATE_TEST_SUITE_P(
    Each, FaultyFinder,
    ::testing::Values(
        NetFault{"AnotherFormat", [](NetFile& f) { f.metadata["format"] = "graspdb descriptor"; },
                 "format"},
        NetFault{"AnotherStepOfScores", [](NetFile& f) { f.metadata["score_step"] = "0.125"; },
                 "score_step"},
        NetFault{"OtherParts", [](NetFile& f) { f.metadata["parts"] = R"(["hand", "rest"])"; },
                 "parts"},
        NetFault{"FewerOutputsAtTheEnd", [](NetFile& f) { f.layers.pop_back(); }, "4 outputs"},
        NetFault{"AKernelThatShrinksPictures", [](NetFile& f) { f.layers[1].padding = 0; },
                 "layer1.weight"},
        NetFault{"ALayerBesideALaterOne", [](NetFile& f) { f.layers[2].beside = 2; }, "beside"},
        NetFault{"ALayerBesideOneOfAnotherSize", [](NetFile& f) { f.layers[2].beside = 1; },
                 "beside"},
        NetFault{"AStrideOfThree", [](NetFile& f) { f.layers[0].stride = 3; }, "stride"},
        NetFault{"SumsThatOverflow", [](NetFile& f) { f.layers[1].bias[3] = 2147483647; },
                 "layer1.bias"},
        NetFault{"ScoresWhoseDifferencesOverflow",
                 [](NetFile& f) {
                   f.layers[3].bias[3] = 2000000000;
                   f.layers[3].multiplier[3] = 2147483647;
                 },
                 "layer3.multiplier"}),
    [](const auto& fault) { return fault.param.name; });

}  // namespace
}  // namespace graspdb
