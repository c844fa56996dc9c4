// SPDX-License-Identifier: MIT
// A hand as capsules round its bones: coarse, but quick to test against each other.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "graspdb/hand/hand.h"

namespace graspdb {

struct DigitCapsule {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();
  Eigen::Vector3d end = Eigen::Vector3d::Zero();
  double radius = 0;
};

// Signed distances: negative inside, or when they overlap.
double distance(const DigitCapsule& capsule, const Eigen::Vector3d& point);
double distance(const DigitCapsule& a, const DigitCapsule& b);

// One capsule a bone, but none for palm and forearm (radius 0), fitted to the skin that the bone
// moves most.
class DigitCapsules {
 public:
  explicit DigitCapsules(const Hand& hand);
  PerBone<DigitCapsule> pose(const PerBone<RigidTransform>& hand_from_bone) const;

 private:
  PerBone<DigitCapsule> in_bone_;
};

}  // namespace graspdb
