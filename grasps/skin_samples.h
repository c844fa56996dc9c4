// SPDX-License-Identifier: MIT
// The skin that can meet an object: everything but the backs of digits and palm, and the forearm.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// 0 palm and metacarpals of the fingers, 1 thumb with its metacarpal, 2..5 the fingers (digits.h:
// palm or digit); -1 forearm.
int digit_of_bone(int bone);

// Two of the thumb's bones and three of each finger's.
bool is_phalanx(int bone);

// Where the next joint or the tip of a bone lies, in the bone's frame. The forearm has none.
Eigen::Vector3d bone_end(const Skeleton& skeleton, int bone);

class SkinSamples {
 public:
  // Keeps one vertex in `stride` of each digit.
  SkinSamples(const Hand& hand, int stride);

  struct Sample {
    int digit = 0;
    int bone = 0;            // the one with the largest weight
    double along = 0;        // 0 at the bone's joint, 1 at its end
    Eigen::Vector3d normal;  // in the bone's frame
    Eigen::Vector3d bind;    // hand frame
    SkinWeights weights;
  };
  const std::vector<Sample>& samples() const { return samples_; }

  // Those of one area, as indices into samples().
  std::vector<int> in_area(const ContactArea& area) const;

  // Positions in the hand frame, one a sample.
  std::vector<Eigen::Vector3d> pose(const PerBone<RigidTransform>& hand_from_bone) const;

 private:
  PerBone<RigidTransform> bone_at_bind_from_hand_;
  std::vector<Sample> samples_;
};

// The outward direction of a side of a bone, in the bone's frame.
Eigen::Vector3d outward(SkinSide side);

}  // namespace graspdb
