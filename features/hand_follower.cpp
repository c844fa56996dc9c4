// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_follower.h"

#include <algorithm>
#include <utility>

#include "frame_parts.h"
#include "graspdb/features/hog.h"
#include "regions.h"

namespace graspdb {
namespace {

// Frames until the whole frame is looked at again: for more of the same hand, for another one.
constexpr int kGlance = 4, kFollowed = 20;
constexpr double kSuddenly = 0.5;  // of the pixels from one frame to the next: some are lost
constexpr double kMore = 1.1, kMuchMore = 2;  // times the pixels, of the same hand and of another

// Times the unlikeness of the net's hand. The net knows more than colour does: the best of 0.7 to 1
// on photoreal training frames.
constexpr double kClearly = 0.85;

double pixels(const FoundHand& found) {
  return static_cast<double>(std::count(found.hand.begin(), found.hand.end(), 255));
}

// An object cuts a hand into pieces, and around one of them the others may not be seen. With an
// arm of its own a piece is no other hand.
bool is_more_of(const FoundHand& any, const FoundHand& again) {
  return pixels(any) >= kMore * pixels(again) && touch(any.hand, again.hand) &&
         !is_empty(any.arm) && (is_empty(again.arm) || touch(any.arm, again.arm));
}

// Of a video whose pictures have had another size nothing is known.
bool is_within(const Box& box, const ColorImage& frame) {
  return box.x + box.width <= frame.width() && box.y + box.height <= frame.height();
}

}  // namespace

HandFollower::HandFollower(FinderOptions options, std::optional<Box> roi)
    : options_(std::move(options)), roi_(roi) {}

void HandFollower::forget() {
  last_.reset();
  taken_.reset();
}

std::optional<FoundHand> HandFollower::follow(const ColorImage& frame) {
  std::optional<FoundHand> again;
  if (last_) again = options_.net->find_again(frame, *last_);
  const bool some_lost = !again || pixels(*again) < kSuddenly * last_px_;
  if (++followed_ % kGlance != 0 && !some_lost) return again;
  const bool may_change = some_lost || followed_ >= kFollowed;
  if (may_change) followed_ = 0;
  std::optional<FoundHand> any = options_.net->find(frame, roi_);
  if (!again || !any) return again ? again : any;
  const bool changes = may_change && pixels(*any) >= kMuchMore * pixels(*again);
  return changes || is_more_of(*any, *again) ? any : again;
}

FoundHand HandFollower::net_hand(const ColorImage& frame) {
  const Mask nothing(frame.width(), frame.height());
  FoundHand found = follow(frame).value_or(FoundHand{nothing, nothing});
  last_ = tight_box(found.hand);
  last_px_ = pixels(found);
  return found;
}

FoundHand HandFollower::likelier(const ColorImage& frame, FoundHand found) const {
  const GrayImage gray = to_gray(frame);
  const double unlike = options_.unlikeness(gray, found.hand);
  if (unlike == 0) return found;
  FoundHand by_color = find_by_color(frame, roi_, options_.skin);
  const std::optional<Box> box = tight_box(by_color.hand);
  if (!box) return found;
  const bool may_be =
      !taken_ || gap_between(*box, *taken_) == 0 || touch(by_color.hand, found.hand);
  if (may_be && options_.unlikeness(gray, by_color.hand) < kClearly * unlike) return by_color;
  return found;
}

FoundHand HandFollower::next(const ColorImage& frame) {
  if (!options_.net) return find_hand(frame, roi_, options_);
  for (const std::optional<Box>& before : {last_, taken_}) {
    if (before && !is_within(*before, frame)) forget();
  }
  FoundHand found = net_hand(frame);
  if (!last_) return found;
  if (options_.unlikeness) found = likelier(frame, std::move(found));
  taken_ = tight_box(found.hand);
  return found;
}

}  // namespace graspdb
