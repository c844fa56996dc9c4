// SPDX-License-Identifier: MIT
// Where a hand in some pose must be to cover the hand that is seen.
#pragma once

#include <Eigen/Core>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

// A hand that is drawn, as capsules around its bones, without the hand itself.
struct PosedHand {
  Keypoints from_palm;  // from the palm's centre, along the camera's axes, metres
  double length;        // hand_length()
};

// The palm's centre, camera frame, near `palm_center`, from where the hand best covers the mask,
// whose box is `box`: up to `reach` times the box's longer side beside it, each way, and a sixth
// nearer or further. Seen pixels that are not covered are dear, less so at the wrist, as masks end
// there somewhere. Covering others is cheap: an object may hide a hand. `palm_center` itself when
// the hand would reach behind the camera there. Thread-safe.
Eigen::Vector3d laid_over(const Mask& mask, const Box& box, const Intrinsics& camera,
                          const PosedHand& hand, const Eigen::Vector3d& palm_center, double reach);

}  // namespace graspdb
