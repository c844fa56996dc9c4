// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "arm_profile.h"
#include "graspdb/error.h"
#include "graspdb/hog.h"
#include "graspdb/segmentation.h"
#include "opencv_image.h"

namespace graspdb {
namespace {

// Enough pixels to measure an arm, and no more: the longer side of its box when measured.
constexpr int kMeasuredSide = 160;

// How far before the palm's start, which is some 25 mm beyond the wrist joint, an arm is cut.
constexpr float kKeptInRadii = 1.2F;

// The mask's box in fewer pixels, `factor` by `factor` of the picture's each; (0, 0) is at
// `origin`.
struct SmallPicture {
  cv::Mat mask;
  cv::Point origin;
  int factor;
};

// The box is grown by background where it does not touch the picture's border, so that the closing
// does not reach the small picture's border either.
SmallPicture shrink(const Mask& hand, const Box& box) {
  const int factor = (std::max(box.width, box.height) - 1) / kMeasuredSide + 1;
  const int margin = 3 * factor;
  const cv::Rect grown(box.x - margin, box.y - margin, box.width + 2 * margin,
                       box.height + 2 * margin);
  const cv::Rect part = grown & cv::Rect(0, 0, hand.width(), hand.height());
  cv::Mat small, closed;
  cv::resize(as_mat(hand)(part), small,
             cv::Size((part.width + factor - 1) / factor, (part.height + factor - 1) / factor), 0,
             0, cv::INTER_AREA);
  // Bad light makes notches.
  cv::morphologyEx(small > 127, closed, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3)));
  return {closed, part.tl(), factor};
}

// The median radius over the first quarter of the way: forearm, if there is any.
float arm_radius(const std::vector<float>& radius) {
  std::vector<float> first(radius.begin(),
                           radius.begin() + static_cast<std::ptrdiff_t>(radius.size() / 4 + 1));
  const auto middle = first.begin() + static_cast<std::ptrdiff_t>(first.size() / 2);
  std::nth_element(first.begin(), middle, first.end());
  return *middle;
}

struct Palm {
  int start;     // pixels along the arm
  float radius;  // as if seen flat
};

// The palm's widest place is wide for this arm (fingers are not), comes after a narrower one (the
// elbow's side of a forearm does not) and is near the fingertips: 3 to 4.5 of its radii (40 mm)
// from those of stretched fingers, up to 8 when the hand is seen edge-on (20 mm). The palm starts
// where the arm, after its narrowest place, has nearly that width: the widest place itself may be
// anywhere between the thumb's root and the knuckles.
std::optional<Palm> find_palm(const std::vector<float>& radius) {
  const int end = static_cast<int>(radius.size());
  const auto at = [&](int k) { return radius[static_cast<std::size_t>(k)]; };
  constexpr float kWidening = 1.05F, kReachInRadii = 8.0F;
  const float arm = arm_radius(radius);
  float widest = 0.75F * arm;
  float widest_after_neck = 0;
  int narrowest = 0;
  std::optional<int> neck;  // the narrowest place before the palm
  for (int k = 0; k < end; ++k) {
    if (at(k) < at(narrowest)) narrowest = k;
    const bool near_tips = static_cast<float>(end - k) <= kReachInRadii * at(k);
    if (at(k) < widest || at(k) < kWidening * at(narrowest) || !near_tips) continue;
    widest = at(k);
    // The fingers of a hand seen edge-on are as wide as its palm: they do not move the neck.
    if (widest < 1.15F * widest_after_neck) continue;
    widest_after_neck = widest;
    neck = narrowest;
  }
  if (!neck) {
    // A stretched hand edge-on, no thicker than its arm: some 170 mm, against an arm of 29.
    const int flat_start = end - static_cast<int>(5.8F * arm);
    return flat_start > 0 ? std::optional(Palm{flat_start, 1.2F * arm}) : std::nullopt;
  }
  const float nearly = std::max(0.85F * widest, std::min(widest, 1.15F * at(*neck)));
  int start = *neck;
  while (at(start) < nearly) ++start;
  return Palm{start, std::max(widest, 1.2F * arm)};
}

// Clears what the arm passes before `cut`: straight across it, but for what lies well beyond.
void clear_before(float cut, float palm_radius, const ArmProfile& arm, const SmallPicture& small,
                  Mask& hand) {
  cv::Point2d here(0, 0), ahead(0, 0);
  int here_count = 0, ahead_count = 0;
  for (int y = 0; y < arm.way.rows; ++y) {
    for (int x = 0; x < arm.way.cols; ++x) {
      const float beyond = arm.way.at<float>(y, x) - cut;
      if (std::abs(beyond) > palm_radius / 2) continue;
      (beyond < 0 ? here : ahead) += cv::Point2d(x, y);
      ++(beyond < 0 ? here_count : ahead_count);
    }
  }
  if (here_count == 0 || ahead_count == 0) return;
  here /= here_count;
  ahead /= ahead_count;
  const cv::Point2d middle = 0.5 * (here + ahead), inwards = ahead - here;
  for (int y = 0; y < arm.way.rows * small.factor; ++y) {
    for (int x = 0; x < arm.way.cols * small.factor; ++x) {
      const cv::Point in_hand = small.origin + cv::Point(x, y);
      if (in_hand.x >= hand.width() || in_hand.y >= hand.height()) continue;
      const cv::Point2d measured((x + 0.5) / small.factor - 0.5, (y + 0.5) / small.factor - 0.5);
      if ((measured - middle).dot(inwards) >= 0) continue;
      const cv::Point at(x / small.factor, y / small.factor);
      const float way = arm.way.at<float>(at);
      const bool connected = way >= 0 || small.mask.at<std::uint8_t>(at) == 0;  // or a rim of it
      if (connected && way < cut + palm_radius) hand.at(in_hand.x, in_hand.y) = 0;
    }
  }
}

}  // namespace

Mask cut_forearm(const Mask& hand) {
  GRASPDB_CHECK(!hand.empty());
  const std::optional<Box> box = tight_box(hand);
  if (!box) return hand;
  const SmallPicture small = shrink(hand, *box);
  const std::optional<ArmProfile> arm = measure_arm(small.mask);
  if (!arm) return hand;
  const std::optional<Palm> palm = find_palm(arm->radius);
  if (!palm) return hand;
  const float cut = static_cast<float>(palm->start) - kKeptInRadii * palm->radius;
  Mask result = hand;
  if (cut > 0) clear_before(cut, palm->radius, *arm, small, result);
  return result;
}

}  // namespace graspdb
