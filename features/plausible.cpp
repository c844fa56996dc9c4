// SPDX-License-Identifier: MIT
#include "plausible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/error.h"
#include "opencv_image.h"

namespace graspdb {
namespace {

// Lengths in square roots of the region's area.
constexpr double kLongestOutline = 13;  // hands 4.8 to 12.5
constexpr double kWidestArm = 1;        // hands 0 to 0.85
// OpenCV's hue, half degrees: 0 is red, 30 yellow, -30 magenta.
constexpr int kLowestHue = -12, kHighestHue = 18;  // hands -10 to 13
// Of a* between the 10th and the 90th percentile.
constexpr int kNarrowestRedness = 3, kWidestRedness = 14;  // hands 5 to 11

using Histogram = std::array<int, 256>;

Histogram histogram_inside(const cv::Mat& channel, const Mask& region) {
  Histogram counts{};
  for (int y = 0; y < region.height(); ++y) {
    const auto* values = channel.ptr<std::uint8_t>(y);
    for (int x = 0; x < region.width(); ++x) {
      if (region.at(x, y) != 0) ++counts[values[x]];
    }
  }
  return counts;
}

// The smallest value that at least this share of the pixels does not exceed.
int quantile(const Histogram& counts, double share) {
  int total = 0;
  for (int count : counts) total += count;
  int below = 0;
  for (int value = 0; value < 256; ++value) {
    below += counts[static_cast<std::size_t>(value)];
    if (below >= share * total) return value;
  }
  return 255;
}

cv::Mat channel_of(const ColorImage& frame, int conversion, int channel) {
  cv::Mat converted, single;
  cv::cvtColor(as_mat(frame), converted, conversion);
  cv::extractChannel(converted, single, channel);
  return single;
}

// Hues turned by half a circle, so that red lies in the middle.
int median_hue(const ColorImage& frame, const Mask& region) {
  constexpr std::size_t kHalf = 90;
  const Histogram hues = histogram_inside(channel_of(frame, cv::COLOR_BGR2HSV, 0), region);
  Histogram turned{};
  for (std::size_t hue = 0; hue < 2 * kHalf; ++hue) turned[(hue + kHalf) % (2 * kHalf)] = hues[hue];
  return quantile(turned, 0.5) - static_cast<int>(kHalf);
}

}  // namespace

bool has_shape_of_hand(const Mask& region) {
  int area = 0, outline = 0, border = 0;
  const int right = region.width() - 1, bottom = region.height() - 1;
  for (int y = 0; y <= bottom; ++y) {
    for (int x = 0; x <= right; ++x) {
      if (region.at(x, y) == 0) continue;
      ++area;
      if (x == 0 || y == 0 || x == right || y == bottom) {
        ++border;
      } else if (region.at(x - 1, y) == 0 || region.at(x + 1, y) == 0 || region.at(x, y - 1) == 0 ||
                 region.at(x, y + 1) == 0) {
        ++outline;
      }
    }
  }
  const double unit = std::sqrt(area);
  return area > 0 && outline <= kLongestOutline * unit && border <= kWidestArm * unit;
}

bool has_color_of_skin(const ColorImage& frame, const Mask& region) {
  GRASPDB_CHECK(frame.width() == region.width() && frame.height() == region.height());
  const int hue = median_hue(frame, region);
  if (hue < kLowestHue || hue > kHighestHue) return false;
  const Histogram redness = histogram_inside(channel_of(frame, cv::COLOR_BGR2Lab, 1), region);
  const int width = quantile(redness, 0.9) - quantile(redness, 0.1);
  return width >= kNarrowestRedness && width <= kWidestRedness;
}

}  // namespace graspdb
