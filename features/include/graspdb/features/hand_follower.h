// SPDX-License-Identifier: MIT
// Finds the same hand in all frames of a video.
#pragma once

#include <optional>

#include "graspdb/core/image.h"
#include "graspdb/features/hand_finder.h"

namespace graspdb {

// Not thread-safe.
class HandFollower {
 public:
  // The first hand is looked for within `roi`, when given, and any other when that is lost.
  explicit HandFollower(FinderOptions options, std::optional<Box> roi = {});

  // The hand in the next frame; masks are all 0 when there is none. With a learned finder: the one
  // where the last was; the whole frame is looked at when there is none, when half of it
  // has gone at once, and every fourth frame, as it may show more of the hand. Another hand, of
  // which much more is seen, is turned to within 20 frames. Four looks at most. By colour each
  // frame is looked at by itself.
  // With FinderOptions::unlikeness: where the net's hand is unlike one (not 0), find_by_color() is
  // asked, too, in `roi` when given. Its hand is taken when it is clearly less unlike one, and is
  // the first of a video or lies where the net's or the last one does.
  FoundHand next(const ColorImage& frame);
  // The next frame is of another video.
  void forget();

 private:
  std::optional<FoundHand> follow(const ColorImage& frame);
  FoundHand net_hand(const ColorImage& frame);
  FoundHand likelier(const ColorImage& frame, FoundHand found) const;

  FinderOptions options_;
  std::optional<Box> roi_, last_;
  std::optional<Box> taken_;  // the last hand that was taken, the net's or another
  double last_px_ = 0;
  int followed_ = 0;  // frames since another hand could have been taken
};

}  // namespace graspdb
