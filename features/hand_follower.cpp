// SPDX-License-Identifier: MIT
#include "graspdb/features/hand_follower.h"

#include <algorithm>
#include <utility>

#include "graspdb/features/hog.h"

namespace graspdb {
namespace {

constexpr int kFollowed = 20;      // frames until the whole frame is looked at again
constexpr double kSuddenly = 0.5;  // of the pixels from one frame to the next: some are lost
constexpr double kMuchMore = 2;    // times the pixels: another hand is followed from now on

double pixels(const FoundHand& found) {
  return static_cast<double>(std::count(found.hand.begin(), found.hand.end(), 255));
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
}

std::optional<FoundHand> HandFollower::follow(const ColorImage& frame) {
  if (last_ && !is_within(*last_, frame)) forget();
  std::optional<FoundHand> again;
  if (last_) again = options_.net->find_again(frame, *last_);
  const bool shrunk = again && pixels(*again) < kSuddenly * last_px_;
  if (again && !shrunk && ++followed_ < kFollowed) return again;
  followed_ = 0;
  std::optional<FoundHand> any = options_.net->find(frame, roi_);
  const bool keeps = again && (!any || pixels(*any) < kMuchMore * pixels(*again));
  return keeps ? again : any;
}

FoundHand HandFollower::next(const ColorImage& frame) {
  if (!options_.net) return find_hand(frame, roi_, options_);
  const Mask nothing(frame.width(), frame.height());
  FoundHand found = follow(frame).value_or(FoundHand{nothing, nothing});
  last_ = tight_box(found.hand);
  last_px_ = pixels(found);
  return found;
}

}  // namespace graspdb
