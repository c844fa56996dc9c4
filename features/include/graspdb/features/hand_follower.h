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
  FoundHand next(const ColorImage& frame);
  // The next frame is of another video.
  void forget();

 private:
  std::optional<FoundHand> follow(const ColorImage& frame);

  FinderOptions options_;
  std::optional<Box> roi_, last_;
  double last_px_ = 0;
  int followed_ = 0;  // frames since another hand could have been taken
};

}  // namespace graspdb
