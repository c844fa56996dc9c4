// SPDX-License-Identifier: MIT
#include "graspdb/pose_file.h"

#include <cmath>
#include <optional>

#include "graspdb/text.h"
#include "graspdb/transform.h"

namespace graspdb {
namespace {

Eigen::Matrix3d read_rotation(const TomlTable& table) {
  constexpr const char* kVector = "rotation_vector_deg";
  const auto turn = [&](const char* key) { return radians(table.number_or(key, 0, -360, 360)); };
  if (!table.has(kVector)) {
    return rotation_from_turns(turn("yaw_deg"), turn("pitch_deg"), turn("roll_deg"));
  }
  for (const char* key : {"yaw_deg", "pitch_deg", "roll_deg"}) {
    if (table.has(key)) table.fail(key, std::string("either this or ") + kVector, "both");
  }
  const std::vector<double> v = table.numbers(kVector, 3, -360, 360);
  return rotation_from_vector(Eigen::Vector3d(v[0], v[1], v[2]) * radians(1));
}

// Whole degrees must not fail by the last bit of a conversion.
double rounded_degrees(double angle) {
  return std::round(degrees(angle) * 1e9) / 1e9;
}

JointAngles read_named_angles(const TomlTable& table) {
  JointAngles angles = JointAngles::Zero();
  for (int i = 0; i < kAngleCount; ++i) {
    const AngleInfo& info = angle_info(i);
    angles[i] = radians(
        table.number_or(info.name, 0, rounded_degrees(info.lower), rounded_degrees(info.upper)));
  }
  table.finish();
  return angles;
}

}  // namespace

Eigen::Matrix3d rotation_from_turns(double yaw, double pitch, double roll) {
  return axis_rotation(2, roll) * axis_rotation(0, pitch) * axis_rotation(1, yaw) *
         axis_rotation(2, kPi);
}

PoseFile load_pose(const std::filesystem::path& file) {
  const TomlTable table = TomlTable::load(file);
  PoseFile pose{read_rotation(table), JointAngles::Zero()};
  if (const auto angles = table.table_if_any("angles_deg")) {
    pose.angles = read_named_angles(*angles);
  }
  table.finish();
  return pose;
}

}  // namespace graspdb
