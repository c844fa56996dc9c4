// SPDX-License-Identifier: MIT
#include "arm_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace graspdb {
namespace {

// The border's pixels, once around.
std::vector<cv::Point> border_of(const cv::Size& size) {
  const int right = size.width - 1, bottom = size.height - 1;
  std::vector<cv::Point> border;
  for (int x = 0; x < right; ++x) border.emplace_back(x, 0);
  for (int y = 0; y < bottom; ++y) border.emplace_back(right, y);
  for (int x = right; x > 0; --x) border.emplace_back(x, bottom);
  for (int y = bottom; y > 0; --y) border.emplace_back(0, y);
  return border;
}

// The longest stretch of the border that lies in the mask.
std::vector<cv::Point> longest_contact(const cv::Mat& mask) {
  const std::vector<cv::Point> border = border_of(mask.size());
  std::vector<cv::Point> longest, current;
  // Twice around, because a stretch may hold the first corner.
  for (std::size_t i = 0; i < 2 * border.size(); ++i) {
    const cv::Point& point = border[i % border.size()];
    if (mask.at<std::uint8_t>(point) == 0) {
      current.clear();
    } else if (current.size() < border.size()) {
      current.push_back(point);
    }
    if (current.size() > longest.size()) longest = current;
  }
  return longest;
}

// Shortest paths over the 8 neighbours. No step is shorter than 1: all whose length has the same
// whole part are reached from shorter ones, so that these rings of pixels are done one by one.
cv::Mat path_lengths(const cv::Mat& mask, const std::vector<cv::Point>& sources) {
  constexpr float kOutside = -1, kUnreached = std::numeric_limits<float>::max();
  cv::Mat framed(mask.rows + 2, mask.cols + 2, CV_32F, cv::Scalar(kOutside));
  cv::Mat length = framed(cv::Rect(cv::Point(1, 1), mask.size()));
  length.setTo(kUnreached, mask);
  std::vector<std::vector<float*>> rings(1);
  const auto reach = [&rings](float* pixel, float at) {
    if (*pixel <= at) return;
    *pixel = at;
    const auto ring = static_cast<std::size_t>(at);
    if (ring >= rings.size()) rings.resize(ring + 1);
    rings[ring].push_back(pixel);
  };
  for (const cv::Point& source : sources) reach(&length.at<float>(source), 0);
  const auto row = static_cast<std::ptrdiff_t>(framed.step1());
  const float straight = 1, diagonal = std::sqrt(2.0F);
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    for (float* from : std::vector<float*>(std::move(rings[ring]))) {
      for (const std::ptrdiff_t step : {row, std::ptrdiff_t{1}}) {
        reach(from - step, *from + straight);
        reach(from + step, *from + straight);
      }
      for (const std::ptrdiff_t step : {row - 1, row + 1}) {
        reach(from - step, *from + diagonal);
        reach(from + step, *from + diagonal);
      }
    }
  }
  length.setTo(kOutside, length == kUnreached);
  return length;
}

// Counts a circle for the entries next to its own too, because path lengths over a grid skip some.
void raise_radius(int k, float radius, std::vector<float>& radii) {
  if (k >= static_cast<int>(radii.size())) radii.resize(static_cast<std::size_t>(k) + 1);
  const int end = std::min(k + 2, static_cast<int>(radii.size()));
  for (int i = std::max(0, k - 1); i < end; ++i) {
    float& known = radii[static_cast<std::size_t>(i)];
    known = std::max(known, radius);
  }
}

}  // namespace

std::optional<ArmProfile> measure_arm(const cv::Mat& mask) {
  cv::Mat inscribed;
  cv::distanceTransform(mask, inscribed, cv::DIST_L2, 5);
  double widest = 0;
  cv::minMaxLoc(inscribed, nullptr, &widest);
  const std::vector<cv::Point> contact = longest_contact(mask);
  constexpr double kArmWidthInRadii = 0.8;
  if (static_cast<double>(contact.size()) < kArmWidthInRadii * widest) return std::nullopt;
  ArmProfile profile{path_lengths(mask, contact), {}};
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const float way = profile.way.at<float>(y, x);
      if (way < 0) continue;
      raise_radius(static_cast<int>(way), inscribed.at<float>(y, x), profile.radius);
    }
  }
  return profile;
}

}  // namespace graspdb
