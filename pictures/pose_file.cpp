// SPDX-License-Identifier: MIT
#include "graspdb/pictures/pose_file.h"

#include <optional>

#include "graspdb/core/toml.h"
#include "graspdb/core/transform.h"
#include "graspdb/hand/turns.h"

namespace graspdb {
namespace {

// Until version 0.2 such files said yaw_deg, pitch_deg and roll_deg, and yaw began at the palm.
void refuse_old_turns(const TomlTable& table) {
  for (const char* key : {"yaw_deg", "pitch_deg", "roll_deg"}) {
    if (!table.has(key)) continue;
    table.fail(key, "view_deg = [yaw + 180, pitch, roll], which begins at the back of the hand",
               "the key of an older version");
  }
}

Eigen::Vector3d degrees3(const TomlTable& table, const char* key) {
  return table.vector3(key, -720, 720) * radians(1);
}

Eigen::Matrix3d read_rotation(const TomlTable& table) {
  constexpr const char* kVector = "rotation_vector_deg";
  constexpr const char* kTurns = "view_deg";
  refuse_old_turns(table);
  if (table.has(kVector) && table.has(kTurns))
    table.fail(kTurns, std::string("either this or ") + kVector, "both");
  if (table.has(kVector)) return rotation_from_vector(degrees3(table, kVector));
  return rotation_from_turns(table.has(kTurns) ? degrees3(table, kTurns)
                                               : Eigen::Vector3d::Zero().eval());
}

JointAngles read_named_angles(const TomlTable& table) {
  JointAngles angles = JointAngles::Zero();
  for (int i = 0; i < kAngleCount; ++i) {
    const AngleInfo& info = angle_info(i);
    angles[i] = radians(table.number_or(info.name, 0, info.lower_deg(), info.upper_deg()));
  }
  table.finish();
  return angles;
}

}  // namespace

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
