// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "angle_tables.h"
#include "graspdb/closing.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/text.h"

namespace graspdb {
namespace {

std::string write_vector(const Eigen::Vector3d& v, int decimals) {
  return fmt::format("[{:.{}f}, {:.{}f}, {:.{}f}]", v.x(), decimals, v.y(), decimals, v.z(),
                     decimals);
}

Eigen::Vector3d read_vector(const TomlTable& table, std::string_view key) {
  const std::vector<double> v = table.numbers(key, 3, -1000, 1000);
  return {v[0], v[1], v[2]};
}

GraspPose read_pose(const TomlTable& table) {
  GraspPose pose;
  pose.angles = read_angles(table);
  pose.hand_from_object.translation = read_vector(table, "object_position_mm") / 1000;
  pose.hand_from_object.rotation =
      rotation_from_vector(read_vector(table, "object_rotation_deg") * radians(1));
  return pose;
}

}  // namespace

std::map<int, GraspPose> load_closed_poses(const std::filesystem::path& path) {
  const TomlTable file = TomlTable::load(path);
  file.string("hand");
  std::map<int, GraspPose> poses;
  for (const TomlTable& table : file.tables("grasp")) {
    const int id = table.integer("number", 1, 65535);
    if (!poses.emplace(id, read_pose(table)).second) {
      table.fail("number", "a number of its own", std::to_string(id));
    }
    table.finish();
  }
  file.finish();
  return poses;
}

void save_closed_poses(const std::filesystem::path& path, const std::string& hand_name,
                       const std::map<int, GraspPose>& poses) {
  std::string text = fmt::format(
      "# Written by `graspdb grasp close`: each grasp closed on this hand. Do not edit.\n"
      "# object_rotation_deg is the rotation vector of the object's frame in the hand's.\n"
      "hand = \"{}\"\n",
      hand_name);
  for (const auto& [id, pose] : poses) {
    const RigidTransform& placed = pose.hand_from_object;
    const Eigen::Vector3d turned = vector_from_rotation(placed.rotation) / radians(1);
    text += fmt::format("\n[[grasp]]\nnumber = {}\n{}", id, write_angles(pose.angles));
    text += fmt::format("object_position_mm = {}\nobject_rotation_deg = {}\n",
                        write_vector(placed.translation * 1000, 5), write_vector(turned, 6));
  }
  write_text(path, text);
}

}  // namespace graspdb
