// SPDX-License-Identifier: MIT
#include "graspdb/sequences/noise.h"

#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/random.h"

namespace graspdb {

Mask add_segmentation_noise(const Mask& hand, double alpha_percent, std::uint64_t seed,
                            std::uint64_t frame) {
  GRASPDB_CHECK(alpha_percent >= 0 && alpha_percent <= 100);
  Mask noisy = hand;
  if (alpha_percent == 0) return noisy;
  RandomStream random(seed, frame);
  for (std::uint8_t& pixel : noisy) {
    // A number for every pixel, so that a pixel's fate does not depend on the others.
    if (pixel == 0) {
      random.skip();
    } else if (random.uniform() < alpha_percent / 100) {
      pixel = 0;
    }
  }
  const cv::Mat image(noisy.height(), noisy.width(), CV_8U, noisy.data());
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
  cv::erode(image, image, square, {-1, -1}, 3);
  cv::dilate(image, image, square, {-1, -1}, 3);
  return noisy;
}

}  // namespace graspdb
