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

}  // namespace
}  // namespace graspdb
