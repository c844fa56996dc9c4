// SPDX-License-Identifier: MIT
#include "graspdb/hand/named_poses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// In the order of the angles.
using Degrees = std::array<double, kAngleCount>;

constexpr std::array<Degrees, kNamedPoses.size()> kDegrees = {{
    {},
    // On the default hands fingertips and palm overlap by up to 2 mm, as flesh that is pressed, and
    // the thumb comes within 1 mm of the fingers.
    {0, 0,  4, 47,  21, 50, 8,  17, 0,   88, 0, 110, 80, 0, 95, 0, 110, 72,  //
     3, 89, 0, 110, 80, 8,  88, 1,  108, 78},
    // Near what contact closing finds for a 60 mm tube on the male hand. The other adult hands'
    // angles lie within 10 degrees of it, the child's fingers stay up to 18 degrees straighter.
    {0, 0,  9,  58, 38, 20, 0,  16,           //
     0, 37, 4,  48, 29, 1,  43, 0,   54, 32,  //
     2, 42, -4, 52, 31, 4,  34, -10, 44, 26},
    // One meeting of thumb and index for the four default hands: their pulps' middles lie within
    // 3.5 mm, and face each other within 35 degrees.
    {0, 0,  32, 48, 65, 1, 3,  5,           //
     0, 73, 4,  27, 4,  0, 28, 1,  35, 18,  //
     0, 24, -4, 30, 16, 0, 20, -9, 26, 14},
    {0, 0, -5, 20,  10, 10, 0, 15,           //
     0, 5, 1,  98,  62, 0,  5, 0,  100, 65,  //
     1, 6, 0,  100, 65, 2,  8, -1, 96,  60},
}};

std::array<JointAngles, kNamedPoses.size()> in_radians() {
  std::array<JointAngles, kNamedPoses.size()> poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (int a = 0; a < kAngleCount; ++a) {
      poses[i][a] = radians(kDegrees[i][static_cast<std::size_t>(a)]);
    }
  }
  return poses;
}

}  // namespace

const JointAngles& named_pose(std::string_view name) {
  static const std::array<JointAngles, kNamedPoses.size()> poses = in_radians();
  const auto found = std::find(kNamedPoses.begin(), kNamedPoses.end(), name);
  if (found == kNamedPoses.end()) {
    throw Error({"", "pose", fmt::format("one of {}", fmt::join(kNamedPoses, ", ")),
                 fmt::format("\"{}\"", name)});
  }
  return poses[static_cast<std::size_t>(found - kNamedPoses.begin())];
}

}  // namespace graspdb
