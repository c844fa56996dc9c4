// SPDX-License-Identifier: MIT
#include "roll.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// Of what is seen around the hand: a descriptor's crop is a little wider than the hand's box.
constexpr double kMargin = 1.15;
// Pixels a side. Descriptors see less, and turning all of a large hand takes as long as describing.
constexpr double kLongestSide = 128;

Eigen::Matrix3d matrix_of(const Intrinsics& camera) {
  Eigen::Matrix3d image_from_camera;
  image_from_camera << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
  return image_from_camera;
}

// A square of a rolled camera's picture, around the hand.
Intrinsics camera_around(const Intrinsics& camera, const Box& hand, double roll_deg) {
  const double width = hand.width / camera.fx, height = hand.height / camera.fy;
  const double wanted = kMargin * std::hypot(width, height);
  const double focal = std::min(std::sqrt(camera.fx * camera.fy), kLongestSide / wanted);
  const int side = static_cast<int>(std::ceil(focal * wanted)) + 2;
  const Eigen::Vector3d middle =
      camera_from_rolled(roll_deg).transpose() *
      camera.ray(hand.x + (hand.width - 1) / 2.0, hand.y + (hand.height - 1) / 2.0);
  return {side,
          side,
          focal,
          focal,
          (side - 1) / 2.0 - focal * middle.x(),
          (side - 1) / 2.0 - focal * middle.y()};
}

GrayImage resampled(const GrayImage& image, const cv::Matx23d& to_image, int side) {
  GrayImage result(side, side);
  cv::Mat out = as_mat(result);
  cv::warpAffine(as_mat(image), out, to_image, out.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  return result;
}

}  // namespace

Eigen::Matrix3d camera_from_rolled(double roll_deg) {
  return axis_rotation(2, radians(-roll_deg));
}

Observation rolled(const Observation& seen, const Box& hand, double roll_deg) {
  const Intrinsics camera = camera_around(seen.camera, hand, roll_deg);
  const Eigen::Matrix3d to_image =
      matrix_of(seen.camera) * camera_from_rolled(roll_deg) * matrix_of(camera).inverse();
  const cv::Matx23d affine(to_image(0, 0), to_image(0, 1), to_image(0, 2), to_image(1, 0),
                           to_image(1, 1), to_image(1, 2));
  Mask mask = resampled(seen.hand, affine, camera.width);
  cv::Mat shares = as_mat(mask);
  cv::threshold(shares, shares, 127, 255, cv::THRESH_BINARY);
  return {resampled(seen.gray, affine, camera.width), std::move(mask), camera};
}

}  // namespace graspdb
