// SPDX-License-Identifier: MIT
#include "graspdb/tracker/hand_reader.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>

#include "features/color_finder.h"
#include "graspdb/core/error.h"
#include "tracker/bars.h"
#include "tracker/plain_options.h"

namespace graspdb {
namespace {

constexpr int kWidth = 320, kHeight = 240;
const Intrinsics kFrameCamera = guess_camera(kWidth, kHeight);

// A block of skin with light across it before a blue wall, and its mask. It is a square of 90
// pixels, 80 wide on the left half of its height: no picture of it in the mirror is the same.
struct Frame {
  explicit Frame(int left) {
    for (int y = 60; y < 150; ++y) {
      const int right = left + (y < 105 ? 90 : 80);
      for (int x = left; x < right; ++x) {
        color.at(x, y) = {110, 140, static_cast<std::uint8_t>(160 + (x - left) / 2)};
        mask.at(x, y) = 255;
      }
    }
  }
  ColorImage color{kWidth, kHeight, {90, 60, 40}};
  Mask mask{kWidth, kHeight};
};

class Reader : public testing::BarDatabase {
 protected:
  HandReader reader(ReaderOptions options = {}) {
    options.tracker = testing::PlainOptions{.temporal = TemporalModel::kNone, .max_distance = 1000};
    return {*database_, *search_, options};
  }
};

void expect_same(const Estimate& a, const Estimate& b) {
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(a.row, b.row);
  EXPECT_EQ(a.box, b.box);
  EXPECT_EQ(a.hand, b.hand);
  EXPECT_EQ(a.descriptor, b.descriptor);
  EXPECT_EQ(a.joints, b.joints);
}

TEST_F(Reader, AFrameAndItsMaskAreReadAsItsHalvesAre) {
  const Frame frame(100);
  const Estimate whole = reader().read(frame.color, frame.mask, kFrameCamera);
  HandReader by_halves = reader();
  expect_same(by_halves.read(by_halves.observe(to_gray(frame.color), frame.mask, kFrameCamera)),
              whole);
  ASSERT_TRUE(whole.valid);
  EXPECT_EQ(whole.hand, isolate_hand(frame.mask));
  EXPECT_GE(whole.ms.total, whole.ms.segment + whole.ms.describe + whole.ms.search);
}

TEST_F(Reader, WithoutAMaskTheHandIsFoundByItsColor) {
  const Frame frame(100);
  const Estimate estimate = reader().read(frame.color, kFrameCamera);
  EXPECT_EQ(estimate.hand, find_hand(frame.color).hand);
  EXPECT_TRUE(estimate.valid);
}

TEST_F(Reader, TheHandIsTheRegionThatTouchesTheRegionOfInterest) {
  Frame frame(20);
  const Frame other(200);
  for (std::size_t i = 0; i < other.mask.size(); ++i) {
    if (other.mask.data()[i] != 0) frame.color.data()[i] = other.color.data()[i];
  }
  const Box right_half{160, 0, 160, 240};
  HandReader reader = this->reader({.roi = right_half});
  EXPECT_GE(reader.read(frame.color, kFrameCamera).box.x, 160);
}

TEST_F(Reader, AFrameWithoutAHandIsInvalid) {
  const Estimate estimate = reader().read(ColorImage(kWidth, kHeight, {90, 60, 40}), kFrameCamera);
  EXPECT_FALSE(estimate.valid);
  EXPECT_EQ(estimate.box.width, 0);
  EXPECT_TRUE(std::ranges::all_of(estimate.hand, [](std::uint8_t pixel) { return pixel == 0; }));
}

// Not the same as a frame that shows no hand: there is nothing to find one by.
TEST_F(Reader, AFrameWithoutColorIsToldFromOneWithoutAHand) {
  const Frame frame(100);
  ColorImage gray = frame.color;
  for (Bgr& pixel : gray) pixel = {pixel[2], pixel[2], static_cast<std::uint8_t>(pixel[2] + 3)};
  EXPECT_TRUE(reader().read(gray, kFrameCamera).colorless);
  EXPECT_TRUE(reader({.handedness = Handedness::kLeft}).read(gray, kFrameCamera).colorless);
  EXPECT_FALSE(reader().read(gray, frame.mask, kFrameCamera).colorless);
  EXPECT_FALSE(reader().read(frame.color, kFrameCamera).colorless);
  const ColorImage wall(kWidth, kHeight, {90, 60, 40});
  EXPECT_FALSE(reader().read(wall, kFrameCamera).colorless);
}

// In the mirror the bar lies at 160 degrees, as no row does.
TEST_F(Reader, RightAndLeftAreToldByTheNearestRow) {
  const testing::BarPicture picture = testing::bar(radians(20));
  const Observation right{picture.gray, picture.mask, testing::kCamera};
  const Observation left{mirrored(picture.gray), mirrored(picture.mask), testing::kCamera};
  HandReader both = reader({.handedness = Handedness::kAuto});
  EXPECT_FALSE(both.read(right).left_hand);
  both.forget();
  int frames = 0;
  while (!both.read(left).left_hand && frames < 20) ++frames;
  EXPECT_LT(frames, 10) << "in a video a right hand is likelier at first";
  EXPECT_EQ(both.read(left).row, 1u);
  both.forget();
  EXPECT_FALSE(both.read(right).left_hand);
  for (int i = 0; i < 40; ++i) both.read(right);
  EXPECT_FALSE(both.read(left).left_hand) << "firm";
  both.read(Observation{right.gray, Mask(testing::kSide, testing::kSide), testing::kCamera});
  for (int i = 0; i < 20; ++i) both.read(left);
  EXPECT_TRUE(both.read(left).left_hand);
  HandReader still = reader({.handedness = Handedness::kAuto, .still = true});
  EXPECT_TRUE(still.read(left).left_hand);
}

TEST_F(Reader, PhotographsKnowNothingOfEachOther) {
  const Frame frame(100);
  const auto second_answer = [&](bool still) {
    ReaderOptions options{.still = still};
    options.tracker = testing::PlainOptions{.temporal = TemporalModel::kGaussian};
    options.tracker->max_distance = 1000;
    HandReader reader(*database_, *search_, options);
    reader.read(frame.color, frame.mask, kFrameCamera);
    return reader.read(frame.color, frame.mask, kFrameCamera).hypotheses.front().weight;
  };
  EXPECT_NE(second_answer(false), second_answer(true));
}

TEST_F(Reader, AMirroredFrameOfTheOtherHandGivesTheMirroredAnswer) {
  const Frame frame(100);
  const Estimate seen = reader().read(frame.color, frame.mask, kFrameCamera);
  const Estimate other = reader({.handedness = Handedness::kLeft})
                             .read(mirrored(frame.color), mirrored(frame.mask), kFrameCamera);
  ASSERT_TRUE(other.valid);
  EXPECT_EQ(other.row, seen.row);
  EXPECT_EQ(other.hand, mirrored(seen.hand));
  EXPECT_EQ(other.box.x, kWidth - seen.box.x - seen.box.width);
  const Eigen::Vector3d &wrist = seen.camera_from_hand.translation,
                        &other_wrist = other.camera_from_hand.translation;
  EXPECT_NEAR(other_wrist.x(), -wrist.x(), 1e-9);
  EXPECT_NEAR(other_wrist.z(), wrist.z(), 1e-9);
  EXPECT_NEAR(other.camera_from_hand.rotation.determinant(), 1, 1e-9);
  for (int i = 0; i < kKeypointCount; ++i) {
    EXPECT_LT((kFrameCamera.project(other.joints.col(i)) - other.joints_px.col(i)).norm(), 1e-6);
  }
}

// The net takes the larger of two blocks for the hand, colour the one that has a hue of skin.
TEST_F(Reader, OfTwoFindersTheOneIsRightWhoseHandIsNearerToARow) {
  Frame frame(200);
  testing::paint(frame.color, {20, 60, 100, 110}, {160, 40, 200});
  ReaderOptions options;
  options.finder.net = std::make_shared<HandFinder>(testing::color_finder());
  const FoundHand net = find_hand(frame.color, {}, options.finder),
                  color = find_by_color(frame.color);
  const HandUnlikeness unlikeness = unlikeness_to(*database_, *search_, Handedness::kRight);
  const double limit = unlikeness(to_gray(frame.color), net.hand);
  EXPECT_LT(unlikeness(to_gray(frame.color), color.hand), 0.8 * limit);
  EXPECT_EQ(reader(options).read(frame.color, kFrameCamera).hand, color.hand);
  options.finder.unlikeness = [](const GrayImage&, const Mask&) { return 0; };
  EXPECT_EQ(reader(options).read(frame.color, kFrameCamera).hand, net.hand);
}

TEST_F(Reader, UnlikenessIsTheDistanceOfTheNearestRowOfEitherHand) {
  const testing::BarPicture seen = testing::bar(radians(20), 30);
  const auto distance = [&](const GrayImage& gray, const Mask& mask) {
    const Descriptor hog = describe(gray, mask, HogMode::kPaper);
    return std::sqrt(static_cast<double>(search_->nearest(hog, 1).front().squared_distance)) / 255;
  };
  const auto unlikeness = [&](Handedness handedness) {
    return unlikeness_to(*database_, *search_, handedness)(seen.gray, seen.mask);
  };
  const double right = distance(seen.gray, seen.mask),
               left = distance(mirrored(seen.gray), mirrored(seen.mask));
  EXPECT_GT(std::min(right, left), 0);
  EXPECT_NE(right, left);
  EXPECT_DOUBLE_EQ(unlikeness(Handedness::kRight), right);
  EXPECT_DOUBLE_EQ(unlikeness(Handedness::kLeft), left);
  EXPECT_DOUBLE_EQ(unlikeness(Handedness::kAuto), std::min(right, left));
}

TEST_F(Reader, OpensASearchByItsNameAndRefusesAnother) {
  const Frame frame(100);
  HandReader named(*database_, {}, "exact");
  EXPECT_EQ(named.search().nearest(Descriptor{}, 3), search_->nearest(Descriptor{}, 3));
  EXPECT_THROW(HandReader(*database_, {}, "none"), Error);
}

}  // namespace
}  // namespace graspdb
