// SPDX-License-Identifier: MIT
#include "plausible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"

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

// The region's pixels, one after the other; of a large one, those of some rows.
ColorImage colors_inside(const ColorImage& frame, const Mask& region) {
  constexpr int kEnough = 2000;  // colours, to tell quantiles
  const auto inside = static_cast<int>(std::count(region.begin(), region.end(), 255));
  std::vector<Bgr> colors;
  for (int y = 0; y < region.height(); y += 1 + inside / kEnough) {
    for (int x = 0; x < region.width(); ++x) {
      if (region.at(x, y) != 0) colors.push_back(frame.at(x, y));
    }
  }
  ColorImage line(static_cast<int>(colors.size()), 1);
  std::ranges::copy(colors, line.begin());
  return line;
}

Histogram histogram_of(const ColorImage& colors, int conversion, int channel) {
  cv::Mat converted;
  cv::cvtColor(as_mat(colors), converted, conversion);
  Histogram counts{};
  for (int i = 0; i < converted.cols; ++i) ++counts[converted.at<cv::Vec3b>(0, i)[channel]];
  return counts;
}

// Hues turned by half a circle, so that red lies in the middle.
int median_hue(const ColorImage& colors) {
  constexpr std::size_t kHalf = 90;
  const Histogram hues = histogram_of(colors, cv::COLOR_BGR2HSV, 0);
  Histogram turned{};
  for (std::size_t hue = 0; hue < 2 * kHalf; ++hue) turned[(hue + kHalf) % (2 * kHalf)] = hues[hue];
  return quantile(turned, 0.5) - static_cast<int>(kHalf);
}

// Masks hold 0 and 255, whose last bits are counted.
int count_inside(const std::uint8_t* row, int width) {
  int count = 0;
  for (int x = 0; x < width; ++x) count += row[x] & 1;
  return count;
}

// Of the row's pixels but its first and last those with a neighbour of 4 outside.
int count_outline(const Mask& region, int y) {
  const std::uint8_t *above = region.row(y - 1), *row = region.row(y), *below = region.row(y + 1);
  int count = 0;
  for (int x = 1; x < region.width() - 1; ++x) {
    count += row[x] & ~(row[x - 1] & row[x + 1] & above[x] & below[x]) & 1;
  }
  return count;
}

}  // namespace

bool has_shape_of_hand(const Mask& region) {
  const int right = region.width() - 1, bottom = region.height() - 1;
  int area = 0, outline = 0, border = 0;
  for (int y = 0; y <= bottom; ++y) {
    const std::uint8_t* row = region.row(y);
    const int count = count_inside(row, region.width());
    area += count;
    if (count == 0) continue;
    if (y == 0 || y == bottom) {
      border += count;
    } else {
      border += (row[0] & 1) + (row[right] & 1);
      outline += count_outline(region, y);
    }
  }
  const double unit = std::sqrt(area);
  return area > 0 && outline <= kLongestOutline * unit && border <= kWidestArm * unit;
}

bool has_color_of_skin(const ColorImage& frame, const Mask& region) {
  GRASPDB_CHECK(frame.width() == region.width() && frame.height() == region.height());
  const ColorImage colors = colors_inside(frame, region);
  if (colors.empty()) return false;
  const int hue = median_hue(colors);
  if (hue < kLowestHue || hue > kHighestHue) return false;
  const Histogram redness = histogram_of(colors, cv::COLOR_BGR2Lab, 1);
  const int width = quantile(redness, 0.9) - quantile(redness, 0.1);
  return width >= kNarrowestRedness && width <= kWidestRedness;
}

}  // namespace graspdb
