// SPDX-License-Identifier: MIT
// Our pictures seen as OpenCV's, without a copy.
#pragma once

#include <opencv2/core.hpp>

#include "graspdb/image.h"

namespace graspdb {

inline cv::Mat as_mat(GrayImage& image) {
  return {image.height(), image.width(), CV_8UC1, image.data()};
}
// OpenCV knows no const picture: the caller only reads these.
inline cv::Mat as_mat(const GrayImage& image) {
  return as_mat(const_cast<GrayImage&>(image));
}
inline cv::Mat as_mat(const ColorImage& image) {
  return {image.height(), image.width(), CV_8UC3, const_cast<Bgr*>(image.data())};
}

// The box with a margin, as far as it lies in the picture.
inline cv::Rect grown(const Box& box, int margin, const GrayImage& image) {
  const cv::Rect whole(0, 0, image.width(), image.height());
  return whole &
         cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin);
}

}  // namespace graspdb
