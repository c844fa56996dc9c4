// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace graspdb {

// An arm that enters a small picture from its border, measured along its way inwards: `way` is each
// mask pixel's shortest path length (pixels) through the mask from where it enters, negative
// outside the mask; radius[k] is that of the largest circle inside the mask whose centre lies k
// pixels along. The last entry is at the fingertips.
struct ArmProfile {
  cv::Mat way;  // CV_32F
  std::vector<float> radius;
};

// None when the mask does not touch the border over an arm's width. A fingertip on the border is
// narrower than that.
std::optional<ArmProfile> measure_arm(const cv::Mat& mask);

}  // namespace graspdb
