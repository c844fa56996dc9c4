// SPDX-License-Identifier: MIT
// What the check measures of one pose.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossing.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

constexpr double kContactMm = 2;  // what is as near as this touches

// A hand, with what all of its poses share. Keeps a reference. Immutable, thread-safe.
class PoseMeasures {
 public:
  explicit PoseMeasures(const Hand& hand);

  struct Measured {
    StepCheck step;  // without its number and its crossings
    CrossingDepths crossed;
    std::array<double, kPalmAndDigitCount> gap_mm;  // from each digit's skin to the object
  };
  Measured measure(const Grasp& grasp, const GraspPose& pose) const;

  const std::vector<int>& digit() const { return digit_; }  // of each vertex; -1 forearm

 private:
  // The skin of the phalanges of one digit: a tube that is open at the palm.
  struct Tube {
    std::vector<std::uint32_t> vertices;
    std::vector<Triangle> triangles;
  };
  Tube phalanges(int digit) const;
  static double overlap(const Mesh& skin, const Tube& digit, const Tube& other);
  static bool behind_nearest(const Mesh& skin, const Tube& tube, const Eigen::Vector3f& point);
  double deepest_overlap(const Mesh& skin) const;
  std::vector<std::string> touching_bones(const std::vector<double>& to_object) const;

  const Hand& hand_;
  std::vector<std::uint8_t> bones_;  // that moves each vertex most
  std::vector<int> digit_;
  std::array<Tube, kDigitCount> tubes_;
};

}  // namespace graspdb
