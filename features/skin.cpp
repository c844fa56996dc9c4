// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {
namespace {

using GrayShares = std::array<double, 256>;

constexpr int kNeutral = 128;  // a* and b* of grey

// Four counts, because neighbours are alike and who adds to a number waits for who did just before.
GrayShares shares_of(const cv::Mat& image) {
  std::array<std::array<int, 256>, 4> counts{};
  for (int y = 0; y < image.rows; ++y) {
    const std::uint8_t* row = image.ptr(y);
    for (int x = 0; x < image.cols; ++x) ++counts[x % 4U][row[x]];
  }
  GrayShares histogram{};
  for (const auto& count : counts) {
    for (std::size_t level = 0; level < 256; ++level) histogram[level] += count[level];
  }
  return histogram;
}

double count_above(const GrayShares& histogram, int level) {
  return std::accumulate(histogram.begin() + level + 1, histogram.end(), 0.0);
}

// The level that splits what lies above `floor` into two classes with the largest variance between
// them (Otsu 1979); `floor` itself when there is nothing to split.
int otsu_level(const GrayShares& histogram, int floor) {
  double count = 0, sum = 0;
  for (int level = floor + 1; level < 256; ++level) {
    count += histogram[static_cast<std::size_t>(level)];
    sum += level * histogram[static_cast<std::size_t>(level)];
  }
  int best_level = floor;
  double best_variance = 0, low_count = 0, low_sum = 0;
  for (int level = floor + 1; level < 255; ++level) {
    low_count += histogram[static_cast<std::size_t>(level)];
    low_sum += level * histogram[static_cast<std::size_t>(level)];
    if (low_count == 0 || low_count == count) continue;
    const double gap = low_sum / low_count - (sum - low_sum) / (count - low_count);
    const double variance = low_count * (count - low_count) * gap * gap;
    if (variance > best_variance) {
      best_variance = variance;
      best_level = level;
    }
  }
  return best_level;
}

int redness_level(const cv::Mat& redness, const SkinOptions& options) {
  const GrayShares histogram = shares_of(redness);
  const double most = options.max_share * static_cast<double>(redness.total());
  int level = otsu_level(histogram, -1);
  while (count_above(histogram, level) > most) {
    const int higher = otsu_level(histogram, level);
    if (higher == level) break;
    level = higher;
  }
  return std::max(level, kNeutral + options.min_redness);
}

// Violet cloth has a high a* too; what is clearly bluer than grey counts as grey.
cv::Mat redness_of(const cv::Mat& bgr) {
  constexpr int kBluerThanSkin = kNeutral - 16;
  cv::Mat lab, redness(bgr.size(), CV_8U);
  cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
  for (int y = 0; y < lab.rows; ++y) {
    std::transform(lab.ptr<cv::Vec3b>(y), lab.ptr<cv::Vec3b>(y) + lab.cols, redness.ptr(y),
                   [](const cv::Vec3b& color) {
                     return color[2] < kBluerThanSkin ? std::uint8_t{kNeutral} : color[1];
                   });
  }
  return redness;
}

cv::Mat red_skin(const cv::Mat& bgr, const SkinOptions& options) {
  const cv::Mat redness = redness_of(bgr);
  return redness > redness_level(redness, options);
}

cv::Mat skin_in_box(const cv::Mat& bgr, const SkinOptions& options) {
  cv::Mat hsv;
  cv::cvtColor(bgr, hsv, cv::COLOR_BGR2HSV);
  const auto inside = [&](int hue_low, int hue_high) {
    cv::Mat mask;
    cv::inRange(hsv,
                cv::Scalar(hue_low, options.saturation_mean - options.saturation_range,
                           options.value_mean - options.value_range),
                cv::Scalar(hue_high, options.saturation_mean + options.saturation_range,
                           options.value_mean + options.value_range),
                mask);
    return mask;
  };
  constexpr int kHues = 180;
  const int low = options.hue_mean - options.hue_range, high = options.hue_mean + options.hue_range;
  return inside(low, high) | inside(low + kHues, high + kHues) | inside(low - kHues, high - kHues);
}

}  // namespace

Mask segment_skin(const ColorImage& frame, const SkinOptions& options) {
  GRASPDB_CHECK(!frame.empty());
  const cv::Mat bgr = as_mat(frame);
  const cv::Mat skin =
      options.rule == SkinRule::kBox ? skin_in_box(bgr, options) : red_skin(bgr, options);
  Mask mask(frame.width(), frame.height());
  cv::Mat closed = as_mat(mask);
  cv::morphologyEx(skin, closed, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_RECT, cv::Size(3, 3)));
  return mask;
}

bool is_empty(const Mask& mask) {
  return std::all_of(mask.begin(), mask.end(), [](std::uint8_t pixel) { return pixel == 0; });
}

bool has_color(const ColorImage& frame) {
  constexpr int kFaint = 10;  // what compression leaves in a grey picture
  const auto colored = std::count_if(frame.begin(), frame.end(), [](const Bgr& pixel) {
    const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
    return most - least > kFaint;
  });
  return static_cast<std::size_t>(colored) * 1000 > frame.size();
}

GrayImage to_gray(const ColorImage& frame) {
  GrayImage gray(frame.width(), frame.height());
  if (frame.empty()) return gray;
  cv::Mat out = as_mat(gray);
  cv::cvtColor(as_mat(frame), out, cv::COLOR_BGR2GRAY);
  return gray;
}

}  // namespace graspdb
