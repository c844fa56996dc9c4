// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/error.h"
#include "graspdb/hog.h"
#include "graspdb/segmentation.h"
#include "opencv_image.h"
#include "plausible.h"

namespace graspdb {
namespace {

// Half the side of the vote below, as a share of the square root of the hand's area: a pixel or two
// for a hand 100 pixels wide.
constexpr double kSmoothing = 0.02;

// Every pixel becomes what most of its neighbours are: specks, pinholes and the frayed edges of a
// segmentation go, holes as large as an object stay.
void smooth(Mask& hand) {
  const auto area = static_cast<double>(std::count(hand.begin(), hand.end(), 255));
  const int radius = static_cast<int>(std::lround(kSmoothing * std::sqrt(area)));
  const std::optional<Box> box = tight_box(hand);
  if (radius == 0 || !box) return;
  cv::Mat image = as_mat(hand)(grown(*box, radius, hand)), votes;
  cv::blur(image, votes, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::threshold(votes, image, 127, 255, cv::THRESH_BINARY);
}

// The object that a hand holds can cut it into pieces. Those of the skin's other regions count that
// are more than specks and no further from the largest, which may show but half of the hand, than a
// hand is long. What comes in from the picture's border is another arm.
constexpr double kSmallestPiece = 0.005;  // of the largest region's area
constexpr double kWidestGap = 3;          // in square roots of that area

bool touches_border(const Box& box, const Mask& mask) {
  return box.x == 0 || box.y == 0 || box.x + box.width == mask.width() ||
         box.y + box.height == mask.height();
}

Box box_of(const cv::Mat& stats, int label) {
  return {stats.at<int>(label, cv::CC_STAT_LEFT), stats.at<int>(label, cv::CC_STAT_TOP),
          stats.at<int>(label, cv::CC_STAT_WIDTH), stats.at<int>(label, cv::CC_STAT_HEIGHT)};
}

void add_pieces(const Mask& skin, Mask& hand) {
  cv::Mat labels, stats, centroids, gap;
  const int count = cv::connectedComponentsWithStats(as_mat(skin), labels, stats, centroids);
  if (count <= 2) return;  // the background and one region
  cv::distanceTransform(as_mat(hand) == 0, gap, cv::DIST_L2, 3);
  const auto area = static_cast<double>(std::count(hand.begin(), hand.end(), 255));
  for (int label = 1; label < count; ++label) {
    if (stats.at<int>(label, cv::CC_STAT_AREA) < kSmallestPiece * area) continue;
    if (touches_border(box_of(stats, label), hand)) continue;
    const cv::Mat piece = labels == label;
    double nearest = 0;
    cv::minMaxLoc(gap, &nearest, nullptr, nullptr, nullptr, piece);
    if (nearest <= kWidestGap * std::sqrt(area)) as_mat(hand).setTo(255, piece);
  }
}

// Skin is looked for in a picture of no more pixels than these: a hand still has thousands.
constexpr double kMostPixels = 110'000;

// Of the frame's width and height.
int shrink_factor(const ColorImage& frame) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(frame.size()) / kMostPixels)));
}

ColorImage shrink(const ColorImage& frame, int factor) {
  ColorImage small((frame.width() + factor - 1) / factor, (frame.height() + factor - 1) / factor);
  cv::Mat image = as_mat(small);
  cv::resize(as_mat(frame), image, image.size(), 0, 0, cv::INTER_LINEAR);
  return small;
}

// The pixels that hold some of the box.
Box shrink(const Box& box, int factor) {
  const int right = box.x + box.width, bottom = box.y + box.height;
  const int x = box.x / factor, y = box.y / factor;
  return {x, y, (right + factor - 1) / factor - x, (bottom + factor - 1) / factor - y};
}

Mask enlarge(const Mask& small, int width, int height) {
  Mask mask(width, height);
  cv::Mat image = as_mat(mask);
  cv::resize(as_mat(small), image, image.size(), 0, 0, cv::INTER_LINEAR);
  cv::threshold(image, image, 127, 255, cv::THRESH_BINARY);
  return mask;
}

// Nothing is left of a region that has not the shape of a hand with its arm.
Mask hand_in(Mask region) {
  smooth(region);
  if (!has_shape_of_hand(region)) return {region.width(), region.height()};
  return cut_forearm(region);
}

}  // namespace

Mask isolate_hand(const Mask& skin, const std::optional<Box>& roi, const SkinOptions& options) {
  std::optional<Mask> region = largest_region(skin, options.min_area_px, roi);
  if (!region) return {skin.width(), skin.height()};
  add_pieces(skin, *region);
  return hand_in(std::move(*region));
}

std::optional<Mask> find_region(const ColorImage& frame, const std::optional<Box>& roi,
                                const SkinOptions& options) {
  GRASPDB_CHECK(!frame.empty());
  const int factor = shrink_factor(frame);
  const ColorImage small = shrink(frame, factor);
  const std::optional<Mask> region =
      largest_region(segment_skin(small, options), options.min_area_px / (factor * factor),
                     roi ? std::optional(shrink(*roi, factor)) : std::nullopt);
  if (!region || !has_color_of_skin(small, *region)) return std::nullopt;
  return factor == 1 ? *region : enlarge(*region, frame.width(), frame.height());
}

Mask find_hand(const ColorImage& frame, const std::optional<Box>& roi, const SkinOptions& options) {
  std::optional<Mask> region = find_region(frame, roi, options);
  if (!region) return {frame.width(), frame.height()};
  return hand_in(std::move(*region));
}

}  // namespace graspdb
