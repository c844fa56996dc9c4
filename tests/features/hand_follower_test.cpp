// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_follower.h"

#include <gtest/gtest.h>

#include <memory>

#include "features/color_finder.h"
#include "features/pictures.h"

namespace graspdb {
namespace {

using testing::color_finder;
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

constexpr Box kMine{100, 200, 60, 80}, kLarger{400, 180, 72, 96}, kHuge{350, 100, 140, 200};

TEST(HandFollower, StaysWithItsHandWhenALargerOneComes) {
  HandFollower follow = follower();
  EXPECT_EQ(follow.next(frame_with({kMine})).box, kMine);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(follow.next(frame_with({kMine, kLarger})).box, kMine) << i;
}

TEST(HandFollower, FollowsAHandThatMovesByAThirdOfItsLength) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  for (int i = 1; i < 15; ++i) {
    const Box now{kMine.x + 26 * i, kMine.y, kMine.width, kMine.height};
    EXPECT_EQ(follow.next(frame_with({now, {500, 380, 72, 96}})).box, now) << i;
  }
}

TEST(HandFollower, TurnsToAHandOfTwiceThePixelsWithinASecond) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  int frames = 0;
  while (follow.next(frame_with({kMine, kHuge})).box == kMine && frames < 100) ++frames;
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 30);
}

TEST(HandFollower, LooksEverywhereForAHandThatIsLost) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  EXPECT_EQ(follow.next(frame_with({kLarger})).box, kLarger);
  const FoundHand none = follow.next(frame_with({}));
  EXPECT_EQ(testing::area(none.hand), 0);
  EXPECT_EQ(none.hand.width(), 640);
  EXPECT_EQ(follow.next(frame_with({kMine})).box, kMine);
}

TEST(HandFollower, BeginsAgainAfterItForgets) {
  HandFollower follow = follower();
  follow.next(frame_with({kMine}));
  follow.forget();
  EXPECT_EQ(follow.next(frame_with({kMine, kLarger})).box, kLarger);
}

TEST(HandFollower, TheRegionAskedForDecidesWhichHandIsFollowed) {
  HandFollower follow = follower(Box{80, 180, 100, 100});
  EXPECT_EQ(follow.next(frame_with({kMine, kLarger})).box, kMine);
  EXPECT_EQ(testing::area(follow.next(frame_with({kLarger})).hand), 0);
}

}  // namespace
}  // namespace graspdb
