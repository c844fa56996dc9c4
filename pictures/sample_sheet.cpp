// SPDX-License-Identifier: MIT
#include "graspdb/pictures/sample_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kPlaneTile = 96;  // pixels
constexpr int kSampleCaption = 18;
constexpr int kSampleGap = 8;
constexpr int kPlanes = 4;  // three of the crop, and the label
constexpr int kSampleColumns = 4, kMostLines = 25;
constexpr double kMetersPerTile = 0.25;

using Mat = cv::Mat_<cv::Vec3b>;

Mat plane_picture(CropPlane plane) {
  const cv::Mat small(kCropSide, kCropSide, CV_8U, plane.data());
  cv::Mat large;
  Mat picture;
  cv::resize(small, large, {kPlaneTile, kPlaneTile}, 0, 0, cv::INTER_LINEAR);
  cv::cvtColor(large, picture, cv::COLOR_GRAY2BGR);
  return picture;
}

// Thumb red, little finger blue; joints further away are darker.
Mat label_picture(const Sample& sample) {
  Mat picture(kPlaneTile, kPlaneTile, cv::Vec3b(24, 24, 24));
  const auto place = [&](int joint) {
    const Eigen::Vector2d at = sample.joints.col(joint).head<2>() * (kPlaneTile / kMetersPerTile);
    return cv::Point(static_cast<int>(kPlaneTile / 2 + at.x()),
                     static_cast<int>(kPlaneTile / 2 + at.y()));
  };
  for (int joint = 1; joint < kKeypointCount; ++joint) {
    const int digit = (joint - 1) / 4, parent = joint % 4 == 1 ? 0 : joint - 1;
    const double depth = sample.joints(2, joint) / kMetersPerTile;
    const double light = std::clamp(0.75 - 2 * depth, 0.3, 1.0);
    const cv::Scalar color(60 * digit * light, 160 * light, (240 - 55 * digit) * light);
    cv::line(picture, place(parent), place(joint), color, 2, cv::LINE_AA);
  }
  return picture;
}

std::string caption(const Sample& sample) {
  return fmt::format("hand {} {}", sample.hand,
                     sample.held ? fmt::format("grasp {}", sample.grasp) : "free");
}

}  // namespace

ColorImage draw_sample_sheet(std::span<const Sample> samples) {
  const int count = std::min(static_cast<int>(samples.size()), kSampleColumns * kMostLines);
  const int lines = (count + kSampleColumns - 1) / kSampleColumns;
  Page page(kSampleColumns * (kPlanes * kPlaneTile + kSampleGap),
            lines * (kPlaneTile + kSampleCaption));
  for (int i = 0; i < count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    const int x = i % kSampleColumns * (kPlanes * kPlaneTile + kSampleGap),
              y = i / kSampleColumns * (kPlaneTile + kSampleCaption);
    page.place(plane_picture(sample.crop.gray), x, y);
    page.place(plane_picture(sample.crop.mask), x + kPlaneTile, y);
    page.place(plane_picture(sample.crop.scene), x + 2 * kPlaneTile, y);
    page.place(label_picture(sample), x + 3 * kPlaneTile, y);
    page.write_small(caption(sample), x + 4, y + kPlaneTile + 12);
  }
  return page.image();
}

}  // namespace graspdb
