// SPDX-License-Identifier: MIT
// How well a hand was found in one frame of a sequence.
#pragma once

#include <limits>

#include "graspdb/core/image.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {

struct Finding {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double iou = kNone;     // with the true hand; none where neither is there
  bool missed = false;    // a hand is seen, and none was found
  bool imagined = false;  // none is seen, and one was found
  // How far the found hand's end towards the arm lies from the true one's, along the arm. None
  // where a mask is empty or the arm points at the camera to 30 degrees.
  double wrist_mm = kNone;
};

// `found` and `truth`, which has kHandBeyondWrist of the arm, are of the camera's size.
Finding compare_masks(const Mask& found, const Mask& truth, const FrameTruth& frame,
                      const Skeleton& skeleton, const Intrinsics& camera);

// Intersection over union of two masks of one size; NaN when both are empty.
double mask_iou(const Mask& a, const Mask& b);

}  // namespace graspdb
