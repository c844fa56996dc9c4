// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

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
  if (radius == 0) return;
  cv::Mat image = as_mat(hand), votes;
  cv::blur(image, votes, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::threshold(votes, image, 127, 255, cv::THRESH_BINARY);
}

}  // namespace

Mask isolate_hand(const Mask& skin, const std::optional<Box>& roi, const SkinOptions& options) {
  std::optional<Mask> region = largest_region(skin, options.min_area_px, roi);
  if (!region) return {skin.width(), skin.height()};
  smooth(*region);
  if (!has_shape_of_hand(*region)) return {skin.width(), skin.height()};
  return cut_forearm(*region);
}

Mask find_hand(const ColorImage& frame, const std::optional<Box>& roi, const SkinOptions& options) {
  const Mask skin = segment_skin(frame, options);
  const std::optional<Mask> region = largest_region(skin, options.min_area_px, roi);
  if (!region || !has_color_of_skin(frame, *region)) return {frame.width(), frame.height()};
  return isolate_hand(*region, roi, options);
}

}  // namespace graspdb
