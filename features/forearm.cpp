// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "arm_profile.h"
#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/hog.h"
#include "graspdb/features/segmentation.h"

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

int measured_factor(const Box& box) {
  return (std::max(box.width, box.height) - 1) / kMeasuredSide + 1;
}

// Of background around the box, in pixels of the small picture: the closing does not reach the
// small picture's border unless the mask touches the picture's.
constexpr int kMargin = 3;

// Where no arm can come in.
bool is_inside(const Box& box, const Mask& picture) {
  const int margin = kMargin * measured_factor(box);
  return std::min(box.x, box.y) >= margin && box.x + box.width + margin <= picture.width() &&
         box.y + box.height + margin <= picture.height();
}

SmallPicture shrink(const Mask& hand, const Box& box) {
  const int factor = measured_factor(box);
  const cv::Rect part = grown(box, kMargin * factor, hand);
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

// A straight line across the arm, in pixels of the small picture.
struct Line {
  cv::Point2d middle, inwards;
  bool is_before(const cv::Point2d& point) const { return (point - middle).dot(inwards) < 0; }
};

// Between the middles of what the arm passes shortly before `cut` and shortly after.
std::optional<Line> line_at(float cut, float palm_radius, const cv::Mat& way) {
  cv::Point2d here(0, 0), ahead(0, 0);
  int here_count = 0, ahead_count = 0;
  for (int y = 0; y < way.rows; ++y) {
    for (int x = 0; x < way.cols; ++x) {
      const float beyond = way.at<float>(y, x) - cut;
      if (std::abs(beyond) > palm_radius / 2) continue;
      (beyond < 0 ? here : ahead) += cv::Point2d(x, y);
      ++(beyond < 0 ? here_count : ahead_count);
    }
  }
  if (here_count == 0 || ahead_count == 0) return std::nullopt;
  here /= here_count;
  ahead /= ahead_count;
  return Line{0.5 * (here + ahead), ahead - here};
}

// Of the hand's pixels that make up one of the small picture's those before the line.
void clear_before(const Line& line, const SmallPicture& small, const cv::Point& at, Mask& hand) {
  const cv::Point corner = small.origin + small.factor * at;
  const int right = std::min(corner.x + small.factor, hand.width());
  const int bottom = std::min(corner.y + small.factor, hand.height());
  const auto measured = [&](int i, int origin) { return (i - origin + 0.5) / small.factor - 0.5; };
  for (int y = corner.y; y < bottom; ++y) {
    for (int x = corner.x; x < right; ++x) {
      std::uint8_t& pixel = hand.at(x, y);
      if (pixel == 0) continue;
      if (line.is_before({measured(x, small.origin.x), measured(y, small.origin.y)})) pixel = 0;
    }
  }
}

// Clears what the arm passes before `cut`: straight across it, but for what lies well beyond.
void clear_arm(float cut, float palm_radius, const cv::Mat& way, const SmallPicture& small,
               Mask& hand) {
  const std::optional<Line> line = line_at(cut, palm_radius, way);
  if (!line) return;
  for (int y = 0; y < way.rows; ++y) {
    for (int x = 0; x < way.cols; ++x) {
      const float passed = way.at<float>(y, x);
      const bool connected = passed >= 0 || small.mask.at<std::uint8_t>(y, x) == 0;  // or its rim
      if (connected && passed < cut + palm_radius) clear_before(*line, small, {x, y}, hand);
    }
  }
}

}  // namespace

Mask cut_forearm(const Mask& hand) {
  GRASPDB_CHECK(!hand.empty());
  const std::optional<Box> box = tight_box(hand);
  if (!box || is_inside(*box, hand)) return hand;
  const SmallPicture small = shrink(hand, *box);
  const std::optional<ArmProfile> arm = measure_arm(small.mask);
  if (!arm) return hand;
  const std::optional<Palm> palm = find_palm(arm->radius);
  if (!palm) return hand;
  const float cut = static_cast<float>(palm->start) - kKeptInRadii * palm->radius;
  Mask result = hand;
  if (cut > 0) clear_arm(cut, palm->radius, arm->way, small, result);
  return result;
}

}  // namespace graspdb
