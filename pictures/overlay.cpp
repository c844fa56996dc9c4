// SPDX-License-Identifier: MIT
#include "graspdb/pictures/overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// A colour a digit, thumb to little finger.
const cv::Scalar kDigitColors[] = {
    {60, 60, 255}, {60, 200, 255}, {80, 230, 80}, {255, 180, 60}, {255, 90, 200}};

cv::Mat gray_to_color(const GrayImage& image) {
  cv::Mat color;
  cv::cvtColor(as_mat(image), color, cv::COLOR_GRAY2BGR);
  return color;
}

cv::Point joint_at(const Estimate& estimate, int joint) {
  const auto limited = [](double v) {
    return static_cast<int>(std::lround(std::clamp(v, -1e5, 1e5)));
  };
  return {limited(estimate.joints_px(0, joint)), limited(estimate.joints_px(1, joint))};
}

void draw_skeleton(cv::Mat& frame, const Estimate& estimate) {
  const int thickness = std::max(2, frame.rows / 240);
  for (int digit = 0; digit < 5; ++digit) {
    for (int segment = 0; segment < 4; ++segment) {
      const int to = 1 + 4 * digit + segment;
      const int from = segment == 0 ? 0 : to - 1;
      cv::line(frame, joint_at(estimate, from), joint_at(estimate, to), kDigitColors[digit],
               thickness, cv::LINE_AA);
      cv::circle(frame, joint_at(estimate, to), thickness + 1, kDigitColors[digit], cv::FILLED,
                 cv::LINE_AA);
    }
  }
  const Box& box = estimate.box;
  cv::rectangle(frame, {box.x, box.y, box.width, box.height}, {255, 255, 255}, 1);
}

// Each cell's bins as strokes along the edge that they stand for, their brightness the value.
cv::Mat draw_hog(DescriptorView hog, int side) {
  cv::Mat picture(side, side, CV_8UC3, cv::Scalar(24, 24, 24));
  const double cell = side / 8.0;
  for (int i = 0; i < kDescriptorSize; ++i) {
    const double strength = std::min(1.0, std::pow(hog[static_cast<std::size_t>(i)] / 160.0, 2));
    if (strength < 0.05) continue;
    // An edge runs across its gradient.
    const double angle = (i % 8 + 0.5) * kPi / 8 + kPi / 2;
    const int column = i / 8 % 8, row = i / 64;
    const cv::Point2d center((column + 0.5) * cell, (row + 0.5) * cell);
    const cv::Point2d half(std::cos(angle) * cell * 0.45, std::sin(angle) * cell * 0.45);
    cv::line(picture, center - half, center + half, cv::Scalar::all(60 + 195 * strength), 1,
             cv::LINE_AA);
  }
  return picture;
}

// An embedding's bytes say nothing to the eye but how much they change: a square each.
cv::Mat draw_embedding(DescriptorView code, int side) {
  constexpr int kColumns = 8;
  cv::Mat picture(side, side, CV_8UC3, cv::Scalar(24, 24, 24));
  const int rows = static_cast<int>(code.size()) / kColumns;
  for (int i = 0; i < static_cast<int>(code.size()); ++i) {
    const int x = i % kColumns * side / kColumns, y = i / kColumns * side / rows;
    cv::rectangle(picture, {x, y, side / kColumns - 2, side / rows - 2},
                  cv::Scalar::all(code[static_cast<std::size_t>(i)]), cv::FILLED);
  }
  return picture;
}

cv::Mat draw_descriptor(DescriptorView descriptor, int side) {
  if (descriptor.size() == kDescriptorSize) return draw_hog(descriptor, side);
  if (descriptor.empty()) return {side, side, CV_8UC3, cv::Scalar(24, 24, 24)};
  return draw_embedding(descriptor, side);
}

cv::Mat fitted(const cv::Mat& picture, int height) {
  cv::Mat scaled;
  const int width =
      std::max(1, static_cast<int>(std::lround(1.0 * picture.cols * height / picture.rows)));
  cv::resize(picture, scaled, {width, height}, 0, 0, cv::INTER_AREA);
  return scaled;
}

void write_caption(cv::Mat& panel, const std::string& text) {
  const double scale = panel.rows / 640.0;
  cv::putText(panel, text, {8, panel.rows - 10}, cv::FONT_HERSHEY_SIMPLEX, scale, {0, 0, 0}, 3,
              cv::LINE_AA);
  cv::putText(panel, text, {8, panel.rows - 10}, cv::FONT_HERSHEY_SIMPLEX, scale, {255, 255, 255},
              1, cv::LINE_AA);
}

}  // namespace

ColorImage with_skeleton(const ColorImage& frame, const Estimate& estimate) {
  ColorImage drawn = frame;
  cv::Mat pixels = as_mat(drawn);
  if (estimate.valid) draw_skeleton(pixels, estimate);
  return drawn;
}

ColorImage draw_overlay(const OverlayInput& input, int height) {
  const ColorImage frame = with_skeleton(input.color, input.estimate);
  const cv::Mat estimated = input.answer ? cv::Mat(as_mat(*input.answer))
                                         : cv::Mat(height, height, CV_8UC3, cv::Scalar(24, 24, 24));
  cv::Mat panels[] = {
      fitted(as_mat(frame), height), fitted(gray_to_color(input.estimate.hand), height),
      draw_descriptor(input.estimate.descriptor, height), fitted(estimated, height)};
  write_caption(panels[0], input.caption);
  cv::Mat joined;
  cv::hconcat(panels, 4, joined);
  // Video encoders want even sides.
  return to_color_image(joined(cv::Rect(0, 0, joined.cols & ~1, joined.rows & ~1)));
}

}  // namespace graspdb
