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

}  // namespace graspdb
