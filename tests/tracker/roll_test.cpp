// SPDX-License-Identifier: MIT
// Frames that are looked at by rolled cameras, too.
#include "roll.h"

#include <gtest/gtest.h>

#include "graspdb/features/hog.h"
#include "graspdb/tracker/hand_reader.h"
#include "tracker/bars.h"
#include "tracker/one_row.h"
#include "tracker/plain_options.h"

namespace graspdb {
namespace {

using testing::bar;
using testing::BarPicture;
using testing::kCamera;
using testing::kSide;
using testing::OneRow;
using testing::PlainOptions;

Observation seen(const BarPicture& picture) {
  return {picture.gray, picture.mask, kCamera};
}

Observation rolled_bar(double angle, double roll_deg) {
  const Observation frame = seen(bar(angle));
  return rolled(frame, tight_box(frame.hand).value(), roll_deg);
}

TEST(Roll, TurnsTheHandClockwise) {
  const Observation turned = rolled_bar(radians(20), 40);
  const BarPicture expected = bar(radians(60));
  int shown = 0, same = 0;
  for (int y = 0; y < turned.hand.height(); ++y) {
    for (int x = 0; x < turned.hand.width(); ++x) {
      const Eigen::Vector2d at = kCamera.project(turned.camera.ray(x, y));
      const auto u = std::lround(at.x()), v = std::lround(at.y());
      if (u < 0 || v < 0 || u >= kSide || v >= kSide) continue;
      const bool inside = expected.mask.at(static_cast<int>(u), static_cast<int>(v)) != 0;
      ++shown;
      same += inside == (turned.hand.at(x, y) != 0) ? 1 : 0;
    }
  }
  EXPECT_GT(shown, 72 * 24);
  EXPECT_GT(same, 0.97 * shown);
}

TEST(Roll, TheCameraSeesTheSameRays) {
  for (const double roll_deg : {-40.0, 15.0, 90.0}) {
    const Observation frame = seen(bar(radians(20)));
    const Observation turned = rolled_bar(radians(20), roll_deg);
    const auto middle = [](const Observation& of) {
      const Box box = tight_box(of.hand).value();
      return of.camera.ray(box.x + (box.width - 1) / 2.0, box.y + (box.height - 1) / 2.0);
    };
    // The bar's middle is its box's, however it is turned.
    const Eigen::Vector3d back = camera_from_rolled(roll_deg) * middle(turned);
    EXPECT_LT((back - middle(frame)).norm(), 1.5 / kCamera.fx);
  }
}

TEST(Roll, ShowsLargeHandsSmallerAndAllOfThem) {
  const Intrinsics camera{.width = 1280, .height = 960, .fx = 900, .fy = 900, .cx = 640, .cy = 480};
  Observation frame{GrayImage(1280, 960, 90), Mask(1280, 960), camera};
  const Box hand{300, 100, 500, 700};
  for (int y = hand.y; y < hand.y + hand.height; ++y)
    std::fill_n(frame.hand.row(y) + hand.x, hand.width, std::uint8_t{255});
  const Observation turned = rolled(frame, hand, 30);
  EXPECT_LT(turned.gray.width(), 210);
  const double scale = turned.camera.fx / camera.fx;
  const auto area = static_cast<double>(std::count(turned.hand.begin(), turned.hand.end(), 255));
  EXPECT_NEAR(area / (scale * scale), 500.0 * 700, 500.0 * 700 * 0.01);
}

class RolledTracker : public testing::BarDatabase {
 protected:
  Tracker tracker(TemporalModel model, double roll_deg) {
    const PlainOptions options{.temporal = model, .sigma_hog = 0.3, .roll_deg = roll_deg};
    return {*database_, row_1_, options};
  }
  static double angle_deg(const Estimate& estimate) {
    return degrees(vector_from_rotation(estimate.camera_from_hand.rotation).z());
  }

  const OneRow row_1_{*database_, 1};
};

TEST_F(RolledTracker, FindsARowThatLooksLikeTheFrameTurned) {
  EXPECT_FALSE(tracker(TemporalModel::kNone, 0).step(seen(bar(radians(50)))).valid);
  Tracker rolling = tracker(TemporalModel::kNone, 30);
  for (const double angle_deg : {50.0, -10.0}) {
    const Estimate estimate = rolling.step(seen(bar(radians(angle_deg))));
    EXPECT_EQ(estimate.row, 1u);
    EXPECT_EQ(estimate.roll_deg, 20 - angle_deg);
    EXPECT_EQ(estimate.hypotheses.front().roll_deg, estimate.roll_deg);
    EXPECT_NEAR(this->angle_deg(estimate), angle_deg, 1);
  }
}

TEST_F(RolledTracker, SuccessorsAreOfTheLookThatFoundTheHypothesis) {
  Tracker tracker = this->tracker(TemporalModel::kSuccessors, 30);
  tracker.step(seen(bar(radians(50))));
  const Estimate estimate = tracker.step(seen(bar(radians(70))));
  EXPECT_EQ(estimate.row, 2u);
  EXPECT_EQ(estimate.roll_deg, -30);
  EXPECT_NEAR(angle_deg(estimate), 70, 1);
}

TEST_F(RolledTracker, AHandOfOnePixelIsLookedAtAsFarAsItIsSeen) {
  Observation frame{GrayImage(kSide, kSide, 90), Mask(kSide, kSide), kCamera};
  frame.hand.at(40, 50) = 255;
  EXPECT_NO_THROW(tracker(TemporalModel::kNone, 30).step(frame));
}

TEST_F(RolledTracker, TheRollOfALeftHandIsThatOfItsOwnFrame) {
  const BarPicture right = bar(radians(50));
  const ReaderOptions options{
      .tracker = PlainOptions{.temporal = TemporalModel::kNone, .sigma_hog = 0.3, .roll_deg = 30}};
  ReaderOptions left = options;
  left.handedness = Handedness::kLeft;
  HandReader reader(*database_, row_1_, options), other(*database_, row_1_, left);
  const Estimate a = reader.read(seen(right));
  const Estimate b = other.read({mirrored(right.gray), mirrored(right.mask), kCamera});
  EXPECT_EQ(a.roll_deg, -30);
  EXPECT_EQ(b.roll_deg, 30);
  EXPECT_EQ(b.hypotheses.front().roll_deg, 30);

  const BarPicture as_it_is = bar(radians(20));
  const Estimate c = other.read({mirrored(as_it_is.gray), mirrored(as_it_is.mask), kCamera});
  EXPECT_EQ(c.roll_deg, 0);
  EXPECT_FALSE(std::signbit(c.roll_deg));  // JSON would have -0.0
}

}  // namespace
}  // namespace graspdb
