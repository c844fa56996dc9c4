// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_follower.h"

#include <gtest/gtest.h>

#include <memory>

#include "features/color_finder.h"
#include "features/pictures.h"
#include "graspdb/features/hog.h"

namespace graspdb {
namespace {

using testing::color_finder;
using testing::kGreen;
using testing::kRed;
using testing::paint;

HandFollower follower(const std::optional<Box>& roi = {}) {
  return HandFollower({.net = std::make_shared<HandFinder>(color_finder())}, roi);
}

ColorImage frame_with(const std::vector<Box>& hands) {
  ColorImage frame(640, 480);
  for (const Box& hand : hands) paint(frame, hand, kRed);
  return frame;
}

std::optional<Box> next(HandFollower& follow, const std::vector<Box>& hands) {
  return tight_box(follow.next(frame_with(hands)).hand);
}

constexpr Box kMine{100, 200, 60, 80}, kLarger{400, 180, 72, 96}, kHuge{350, 100, 140, 200};

TEST(HandFollower, StaysWithItsHandWhenALargerOneComes) {
  HandFollower follow = follower();
  EXPECT_EQ(next(follow, {kMine}), kMine);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(next(follow, {kMine, kLarger}), kMine) << i;
}

TEST(HandFollower, FollowsAHandThatMovesByAThirdOfItsLength) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  for (int i = 1; i < 15; ++i) {
    const Box now{kMine.x + 26 * i, kMine.y, kMine.width, kMine.height};
    EXPECT_EQ(next(follow, {now, {500, 380, 72, 96}}), now) << i;
  }
}

TEST(HandFollower, TurnsToAHandOfTwiceThePixelsWithinASecond) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  int frames = 0;
  while (next(follow, {kMine, kHuge}) == kMine && frames < 100) ++frames;
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 30);
}

// Of a hand behind an object that no finder knows: fingers above it, the palm and its arm below.
TEST(HandFollower, SoonSeesThePalmOfAHandThatItFollowsByItsFingers) {
  constexpr Box kFingers{200, 100, 80, 30}, kBelow{210, 190, 60, 30};
  HandFollower follow = follower();
  EXPECT_EQ(next(follow, {kFingers}), kFingers);
  ColorImage frame = frame_with({kFingers, kBelow});
  paint(frame, {220, 220, 40, 100}, kGreen);
  int frames = 0;
  while (tight_box(follow.next(frame).hand) == kFingers && frames < 100) ++frames;
  EXPECT_LT(frames, 4);
  EXPECT_EQ(tight_box(follow.next(frame).hand), (Box{200, 100, 80, 120}));
}

TEST(HandFollower, LooksEverywhereForAHandThatIsLost) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  EXPECT_EQ(next(follow, {kLarger}), kLarger);
  const FoundHand none = follow.next(frame_with({}));
  EXPECT_EQ(testing::area(none.hand), 0);
  EXPECT_EQ(none.hand.width(), 640);
  EXPECT_EQ(next(follow, {kMine}), kMine);
}

TEST(HandFollower, BeginsAgainAfterItForgets) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  follow.forget();
  EXPECT_EQ(next(follow, {kMine, kLarger}), kLarger);
}

TEST(HandFollower, BeginsAgainInPicturesOfAnotherSize) {
  HandFollower follow = follower();
  EXPECT_EQ(next(follow, {{500, 300, 72, 96}})->x, 500);
  ColorImage small(320, 240);
  paint(small, {40, 50, 60, 80}, kRed);
  EXPECT_EQ(tight_box(follow.next(small).hand), (Box{40, 50, 60, 80}));
}

TEST(HandFollower, TheRegionAskedForDecidesWhichHandIsFollowed) {
  HandFollower follow = follower(Box{80, 180, 100, 100});
  EXPECT_EQ(next(follow, {kMine, kLarger}), kMine);
  EXPECT_FALSE(next(follow, {kLarger}));
}

// What the net takes for the hand has no colour of skin; what has is to the net a smaller hand.
class TwoFinders : public ::testing::Test {
 protected:
  static constexpr Box kNets{100, 180, 100, 120}, kColors{540, 200, 72, 64};

  static ColorImage frame(bool with_skin = true) {
    ColorImage frame(640, 480);
    paint(frame, kNets, {160, 40, 200});
    if (!with_skin) return frame;
    for (int x = kColors.x; x < kColors.x + kColors.width; ++x)
      paint(frame, {x, kColors.y, 1, kColors.height},
            {110, 140, static_cast<std::uint8_t>(160 + (x - kColors.x) / 2)});
    return frame;
  }

  // Where the other one's is 1.
  HandFollower follower(double net_unlike, double color_unlike) {
    return HandFollower({.net = std::make_shared<HandFinder>(color_finder()),
                         .unlikeness = [=, this](const GrayImage& seen, const Mask& hand) {
                           EXPECT_EQ(seen.width(), hand.width());
                           ++asked_;
                           return hand.at(kNets.x + 40, kNets.y + 40) != 0 ? net_unlike
                                                                           : color_unlike;
                         }});
  }

  static bool takes_color(HandFollower& follow, const ColorImage& seen) {
    const Box box = tight_box(follow.next(seen).hand).value();
    return box.x >= kColors.x - 4;
  }

  int asked_ = 0;
};

TEST_F(TwoFinders, TheColorsHandIsTakenWhenItIsClearlyLikelier) {
  HandFollower nearly = follower(1, 0.9), clearly = follower(1, 0.8);
  EXPECT_FALSE(takes_color(nearly, frame()));
  EXPECT_TRUE(takes_color(clearly, frame()));
}

TEST_F(TwoFinders, ColorIsNotAskedWhereNothingIsUnlikeAHand) {
  HandFollower follow = follower(0, 0);
  EXPECT_FALSE(takes_color(follow, frame()));
  EXPECT_EQ(asked_, 1);
}

// The skin is a part of what the net sees, which has moved away from where the last hand was.
TEST_F(TwoFinders, AHandThatOverlapsTheNetsMayBeTaken) {
  HandFollower follow({.net = std::make_shared<HandFinder>(color_finder()),
                       .unlikeness = [](const GrayImage&, const Mask& hand) {
                         return testing::area(hand) > 2 * kColors.width * kColors.height ? 1 : 0.1;
                       }});
  follow.next(frame(false));
  ColorImage moved = frame();
  paint(moved, kNets, {0, 0, 0});
  paint(moved, {kColors.x - 100, kColors.y - 40, 100, 140}, {160, 40, 200});
  EXPECT_LT(tight_box(follow.next(moved).hand)->width, kColors.width + 10);
}

TEST_F(TwoFinders, AFrameWithoutAHandDoesNotMakeItJump) {
  HandFollower follow = follower(1, 0.1);
  follow.next(frame(false));
  follow.next(ColorImage(640, 480));
  EXPECT_FALSE(takes_color(follow, frame()));
}

TEST_F(TwoFinders, PicturesOfAnotherSizeAreAnotherVideo) {
  HandFollower follow = follower(1, 0.1);
  EXPECT_TRUE(takes_color(follow, frame()));
  ColorImage small(320, 240);
  paint(small, {20, 90, 100, 120}, {160, 40, 200});
  EXPECT_EQ(tight_box(follow.next(small).hand), (Box{20, 90, 100, 120}));
}

TEST_F(TwoFinders, WithoutAnotherHandTheNetsStays) {
  HandFollower follow = follower(1, 0.1);
  EXPECT_FALSE(takes_color(follow, frame(false)));
}

TEST_F(TwoFinders, AHandThatIsFollowedIsLeftForNoneElsewhere) {
  HandFollower follow = follower(1, 0.1);
  takes_color(follow, frame(false));
  EXPECT_FALSE(takes_color(follow, frame()));
  follow.forget();
  EXPECT_TRUE(takes_color(follow, frame()));
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(takes_color(follow, frame())) << i;
}

}  // namespace
}  // namespace graspdb
