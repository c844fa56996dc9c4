// SPDX-License-Identifier: MIT
#include "graspdb/hand/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

constexpr AngleInfo in_degrees(std::string_view name, double lower, double upper) {
  return {name, radians(lower), radians(upper)};
}

constexpr std::array<AngleInfo, kAngleCount> kAngles = {{
    in_degrees("wrist_flexion", -70, 80),       in_degrees("wrist_deviation", -35, 20),
    in_degrees("thumb_cmc_flexion", -20, 50),   in_degrees("thumb_cmc_abduction", 0, 62),
    in_degrees("thumb_cmc_axial", -10, 65),     in_degrees("thumb_mcp_flexion", -10, 60),
    in_degrees("thumb_mcp_abduction", -10, 10), in_degrees("thumb_ip_flexion", -15, 80),
    in_degrees("index_cmc_flexion", 0, 2),      in_degrees("index_mcp_flexion", -25, 95),
    in_degrees("index_mcp_abduction", -20, 20), in_degrees("index_pip_flexion", 0, 110),
    in_degrees("index_dip_flexion", -10, 85),   in_degrees("middle_cmc_flexion", 0, 2),
    in_degrees("middle_mcp_flexion", -25, 95),  in_degrees("middle_mcp_abduction", -12, 12),
    in_degrees("middle_pip_flexion", 0, 110),   in_degrees("middle_dip_flexion", -10, 85),
    in_degrees("ring_cmc_flexion", 0, 10),      in_degrees("ring_mcp_flexion", -25, 95),
    in_degrees("ring_mcp_abduction", -15, 15),  in_degrees("ring_pip_flexion", 0, 110),
    in_degrees("ring_dip_flexion", -10, 85),    in_degrees("little_cmc_flexion", 0, 20),
    in_degrees("little_mcp_flexion", -25, 95),  in_degrees("little_mcp_abduction", -30, 15),
    in_degrees("little_pip_flexion", 0, 110),   in_degrees("little_dip_flexion", -10, 85),
}};

// The widest abduction that is left at this flexion.
double faded(double limit, double mcp_flexion) {
  const double narrow = radians(3);
  const double progress = std::clamp(mcp_flexion / radians(80), 0.0, 1.0);
  return limit + (std::min(limit, narrow) - limit) * progress;
}

double rounded_degrees(double angle) {
  return std::round(degrees(angle) * 1e9) / 1e9;
}

}  // namespace

double AngleInfo::lower_deg() const {
  return rounded_degrees(lower);
}

double AngleInfo::upper_deg() const {
  return rounded_degrees(upper);
}

const AngleInfo& angle_info(int angle) {
  GRASPDB_CHECK(angle >= 0 && angle < kAngleCount);
  return kAngles[static_cast<std::size_t>(angle)];
}

JointAngles clamp_to_range(const JointAngles& angles) {
  JointAngles clamped = angles;
  for (int i = 0; i < kAngleCount; ++i) {
    clamped[i] = std::clamp(angles[i], angle_info(i).lower, angle_info(i).upper);
  }
  for (int finger = 0; finger < kFingerCount; ++finger) {
    const int abduction = finger_angle(finger, kMcpAbduction);
    const double flexion = clamped[finger_angle(finger, kMcpFlexion)];
    clamped[abduction] =
        std::clamp(clamped[abduction], -faded(-angle_info(abduction).lower, flexion),
                   faded(angle_info(abduction).upper, flexion));
  }
  return clamped;
}

double range_excess(const JointAngles& angles) {
  return (angles - clamp_to_range(angles)).cwiseAbs().maxCoeff();
}

}  // namespace graspdb
