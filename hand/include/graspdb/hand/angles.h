// SPDX-License-Identifier: MIT
// The 28 joint angles of a hand. Zero is the flat hand: forearm, palm and fingers in one line, the
// thumb straight in the plane of the palm. Flexion is positive towards the palm; deviation and
// abduction towards the thumb's side; thumb abduction away from the palm's plane; the thumb's axial
// rotation when the pulp turns to the fingers.
#pragma once

#include <Eigen/Core>
#include <string_view>

namespace graspdb {

enum Angle {
  kWristFlexion = 0,
  kWristDeviation = 1,
  kThumbCmcFlexion = 2,
  kThumbCmcAbduction = 3,
  kThumbCmcAxial = 4,
  kThumbMcpFlexion = 5,
  kThumbMcpAbduction = 6,
  kThumbIpFlexion = 7,
  kFirstFingerAngle = 8,  // then five angles a finger: see finger_angle
};
constexpr int kAngleCount = 28;
constexpr int kFingerCount = 4;  // index, middle, ring, little

enum FingerAngle {
  kCmcFlexion = 0,
  kMcpFlexion = 1,
  kMcpAbduction = 2,
  kPipFlexion = 3,
  kDipFlexion = 4
};

// The index of an angle of finger 0..3.
constexpr int finger_angle(int finger, FingerAngle angle) {
  return kFirstFingerAngle + 5 * finger + angle;
}

using JointAngles = Eigen::Matrix<double, kAngleCount, 1>;  // radians

struct AngleInfo {
  std::string_view name;  // e.g. "index_pip_flexion"
  double lower;           // radians
  double upper;

  // Degrees as people state them: whole ones do not fail by the last bit of a conversion.
  double lower_deg() const;
  double upper_deg() const;
};

const AngleInfo& angle_info(int angle);

// The ranges with the fingers' abduction faded: from its full range at MCP flexion 0 to +-3 degrees
// at 80 degrees and beyond. Returns the angles moved to the nearest allowed value.
JointAngles clamp_to_range(const JointAngles& angles);

// How far, in radians, the angle furthest outside its range is outside; 0 when all are inside.
double range_excess(const JointAngles& angles);

}  // namespace graspdb
