// SPDX-License-Identifier: MIT
#pragma once

namespace graspdb {

// Evidence for a right or a left hand, from how near the nearest rows of both are: all rows are of
// right hands, to which a left one is shown in the mirror.
class HandednessEvidence {
 public:
  // Three videos in four begin with a right hand; a photograph has but one frame to say otherwise.
  explicit HandednessEvidence(bool still) : for_right_(still ? 0.1 : 2) {}

  void add(double right_distance, double left_distance);
  bool left() const { return for_right_ < 0; }
  // Further frames would hardly change it.
  bool firm() const;

 private:
  double for_right_;
};

}  // namespace graspdb
