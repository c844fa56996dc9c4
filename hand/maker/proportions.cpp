// SPDX-License-Identifier: MIT
#include "proportions.h"

#include <cmath>

#include "graspdb/hand/zero_pose.h"

namespace graspdb {
namespace {

// Joint centres as fractions of hand length, as used in the models that follow Buchholz,
// Armstrong and Goldstein (1992): wrist to MCP, proximal, middle, distal with its pulp.
constexpr double kFingerFractions[kFingerCount][4] = {{.463, .245, .143, .101},
                                                      {.446, .266, .170, .108},
                                                      {.421, .247, .165, .107},
                                                      {.410, .204, .119, .098}};
constexpr double kThumbFractions[3] = {.248, .180, .152};

// For a breadth of kTableBreadthMm and a length of kTableLengthMm.
constexpr double kKnuckleXMm[kFingerCount] = {-22.5, 0, 20, 37.5};
constexpr double kKnuckleRise[kFingerCount] = {-.036, 0, -.006, -.036};  // z / y: transverse arch
constexpr double kCmcMm[kFingerCount][3] = {
    {-12.5, 24, -1}, {-2, 25, 0}, {8.5, 24, -1}, {17, 20, -3}};
constexpr double kThumbCmcMm[3] = {-20, 17, -8};

Eigen::Vector3d scaled(const double (&table_mm)[3], double width, double length) {
  return Eigen::Vector3d(table_mm[0] * width, table_mm[1] * length, table_mm[2] * width) / 1000;
}

// The knuckle at `distance` from the wrist, in the table's direction.
Eigen::Vector3d knuckle(std::size_t finger, double distance, double width) {
  const double x = kKnuckleXMm[finger] * width / 1000, rise = kKnuckleRise[finger];
  const double y = std::sqrt((distance * distance - x * x) / (1 + rise * rise));
  return {x, y, rise * y};
}

// Metres a unit of the fractions, along the palm and along the digits: the middle ray's palm and
// straight finger make up the hand's length.
struct Units {
  double palm, digit;
};

Units units_of(const HandShape& shape) {
  const auto& middle = kFingerFractions[1];
  return {(shape.length_mm - shape.finger_length_mm) / 1000 / middle[0],
          shape.finger_length_mm / 1000 / (middle[1] + middle[2] + middle[3])};
}

}  // namespace

Skeleton skeleton_of_shape(const HandShape& shape, double width) {
  const Units unit = units_of(shape);
  const double length = shape.length_mm / kTableLengthMm;
  HandMeasures measures;
  measures.cmc[0] = scaled(kThumbCmcMm, width, length);
  for (std::size_t bone = 0; bone < 3; ++bone) {
    measures.lengths[0][bone] = kThumbFractions[bone] * (bone == 0 ? unit.palm : unit.digit);
  }
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    measures.cmc[finger + 1] = scaled(kCmcMm[finger], width, length);
    measures.mcp[finger] = knuckle(finger, kFingerFractions[finger][0] * unit.palm, width);
    for (std::size_t phalanx = 0; phalanx < 3; ++phalanx) {
      measures.lengths[finger + 1][phalanx] = kFingerFractions[finger][phalanx + 1] * unit.digit;
    }
  }
  return skeleton_from_measures(measures);
}

JointAngles bind_angles() {
  JointAngles angles = JointAngles::Zero();
  constexpr double kAbductionDeg[kFingerCount] = {9, 1, -8, -17};
  for (int finger = 0; finger < kFingerCount; ++finger) {
    angles[finger_angle(finger, kMcpFlexion)] = radians(30);
    angles[finger_angle(finger, kMcpAbduction)] = radians(kAbductionDeg[finger]);
    angles[finger_angle(finger, kPipFlexion)] = radians(45);
    angles[finger_angle(finger, kDipFlexion)] = radians(25);
  }
  angles[kThumbCmcFlexion] = radians(20);
  angles[kThumbCmcAbduction] = radians(28);
  angles[kThumbCmcAxial] = radians(18);
  angles[kThumbMcpFlexion] = radians(10);
  angles[kThumbIpFlexion] = radians(14);
  return angles;
}

}  // namespace graspdb
