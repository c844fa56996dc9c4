// SPDX-License-Identifier: MIT
// Our pictures seen as OpenCV's, without a copy, and back.
#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "graspdb/core/image.h"

namespace graspdb {

inline cv::Mat as_mat(GrayImage& image) {
  return {image.height(), image.width(), CV_8UC1, image.data()};
}
inline cv::Mat_<cv::Vec3b> as_mat(ColorImage& image) {
  return {image.height(), image.width(), reinterpret_cast<cv::Vec3b*>(image.data())};
}
// OpenCV knows no const picture: the caller only reads these.
inline cv::Mat as_mat(const GrayImage& image) {
  return as_mat(const_cast<GrayImage&>(image));
}
inline cv::Mat_<cv::Vec3b> as_mat(const ColorImage& image) {
  return as_mat(const_cast<ColorImage&>(image));
}

// A copy of a CV_8UC3 picture.
inline ColorImage to_color_image(const cv::Mat& mat) {
  ColorImage image(mat.cols, mat.rows);
  for (int y = 0; y < mat.rows; ++y)
    std::copy_n(reinterpret_cast<const Bgr*>(mat.ptr(y)), mat.cols, image.row(y));
  return image;
}

// The box with a margin, as far as it lies in the picture.
inline cv::Rect grown(const Box& box, int margin, const GrayImage& image) {
  const cv::Rect whole(0, 0, image.width(), image.height());
  return whole &
         cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
}

}  // namespace graspdb
