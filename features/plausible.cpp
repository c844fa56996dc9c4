// SPDX-License-Identifier: MIT
#include "plausible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/error.h"
#include "graspdb/hog.h"
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

cv::Mat converted(const ColorImage& frame, const Box& box, int conversion) {
  cv::Mat result;
  cv::cvtColor(as_mat(frame)(as_rect(box)), result, conversion);
  return result;
}

constexpr int kHalfTurn = 90;

// Of the colours in a region: their hues, turned by half a circle so that red lies in the middle,
// and their redness.
struct Colors {
  Histogram turned_hue{}, redness{};
};

Colors colors_of(const ColorImage& frame, const Mask& region, const Box& box) {
  const cv::Mat hsv = converted(frame, box, cv::COLOR_BGR2HSV);
  const cv::Mat lab = converted(frame, box, cv::COLOR_BGR2Lab);
  Colors colors;
  for (int y = 0; y < box.height; ++y) {
    const std::uint8_t* inside = region.row(box.y + y) + box.x;
    const auto *hsv_row = hsv.ptr<cv::Vec3b>(y), *lab_row = lab.ptr<cv::Vec3b>(y);
    for (int x = 0; x < box.width; ++x) {
      if (inside[x] == 0) continue;
      ++colors.turned_hue[(hsv_row[x][0] + kHalfTurn) % (2U * kHalfTurn)];
      ++colors.redness[lab_row[x][1]];
    }
  }
  return colors;
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
  const std::optional<Box> box = tight_box(region);
  if (!box) return false;
  const Colors colors = colors_of(frame, region, *box);
  const int hue = quantile(colors.turned_hue, 0.5) - kHalfTurn;
  const int width = quantile(colors.redness, 0.9) - quantile(colors.redness, 0.1);
  const bool is_skins_hue = hue >= kLowestHue && hue <= kHighestHue;
  return is_skins_hue && width >= kNarrowestRedness && width <= kWidestRedness;
}

}  // namespace graspdb
