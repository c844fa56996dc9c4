// SPDX-License-Identifier: MIT
#include "handedness.h"

#include <algorithm>
#include <cmath>

namespace graspdb {
namespace {

constexpr double kNearest = 0.05;  // distances below say no more
constexpr double kFirm = 8;        // some 20 frames of the training sequences, all of one mind

}  // namespace

void HandednessEvidence::add(double right_distance, double left_distance) {
  for_right_ += std::log(std::max(left_distance, kNearest) / std::max(right_distance, kNearest));
}

bool HandednessEvidence::firm() const {
  return std::abs(for_right_) > kFirm;
}

}  // namespace graspdb
