// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "angle_tables.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/toml.h"
#include "graspdb/grasps/closing.h"

namespace graspdb {
namespace {

std::string write_vector(const Eigen::Vector3d& v, int decimals) {
  return fmt::format("[{:.{}f}, {:.{}f}, {:.{}f}]", v.x(), decimals, v.y(), decimals, v.z(),
                     decimals);
}

constexpr double kLargest = 1000;  // mm and degrees

GraspPose read_pose(const TomlTable& table) {
  GraspPose pose;
  pose.angles = read_angles(table);
  pose.hand_from_object.translation =
      table.vector3("object_position_mm", -kLargest, kLargest) / 1000;
  pose.hand_from_object.rotation =
      rotation_from_vector(table.vector3("object_rotation_deg", -kLargest, kLargest) * radians(1));
  return pose;
}

bool is_of(const ClosedPoses& closed, const Hand& hand) {
  constexpr double kSameLength = 1e-5;  // metres
  return std::abs(closed.hand_length - hand_length(hand.skeleton)) < kSameLength;
}

}  // namespace

ClosedPoses load_closed_poses(const std::filesystem::path& path) {
  const TomlTable file = TomlTable::load(path);
  ClosedPoses closed{.hand = file.string("hand")};
  closed.hand_length = file.number("hand_length_mm", 100, 300) / 1000;
  for (const TomlTable& table : file.tables("grasp")) {
    const int id = table.integer("number", 1, kLargestGrasp);
    closed.grasp_hashes[id] = table.string("grasp_hash");
    if (!closed.poses.emplace(id, read_pose(table)).second) {
      table.fail("number", "a number of its own", std::to_string(id));
    }
    table.finish();
  }
  file.finish();
  return closed;
}

void save_closed_poses(const std::filesystem::path& path, const ClosedPoses& closed) {
  std::string text = fmt::format(
      "# Written by `graspdb grasp close`: each grasp closed on this hand. Do not edit.\n"
      "# object_rotation_deg is the rotation vector of the object's frame in the hand's.\n"
      "hand = {}\nhand_length_mm = {:.4f}\n",
      toml_string(closed.hand), closed.hand_length * 1000);
  for (const auto& [id, pose] : closed.poses) {
    const RigidTransform& placed = pose.hand_from_object;
    const Eigen::Vector3d turned = vector_from_rotation(placed.rotation) / radians(1);
    text += fmt::format("\n[[grasp]]\nnumber = {}\ngrasp_hash = \"{}\"\n{}", id,
                        closed.grasp_hashes.at(id), write_angles(pose.angles));
    text += fmt::format("object_position_mm = {}\nobject_rotation_deg = {}\n",
                        write_vector(placed.translation * 1000, 5), write_vector(turned, 6));
  }
  write_text(path, text);
}

std::filesystem::path closed_poses_file(const Grasp& grasp, const Hand& hand) {
  return grasp.file.parent_path() / "closed" / (hand.name + ".toml");
}

std::string grasp_hash(const Grasp& grasp) {
  std::string bytes = read_text(grasp.file);
  if (!grasp.object_file.empty()) bytes += read_text(grasp.object_file);
  return hash_hex(bytes);
}

std::filesystem::path keep_closed_poses(const std::vector<Grasp>& grasps, const Hand& hand,
                                        const std::vector<GraspPose>& poses) {
  GRASPDB_CHECK(!grasps.empty() && grasps.size() == poses.size());
  std::filesystem::path file = closed_poses_file(grasps.front(), hand);
  ClosedPoses closed;
  if (std::filesystem::exists(file)) closed = load_closed_poses(file);
  if (!is_of(closed, hand)) {
    closed = {.hand = hand.name, .hand_length = hand_length(hand.skeleton)};
  }
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    closed.poses[grasps[i].id] = poses[i];
    closed.grasp_hashes[grasps[i].id] = grasp_hash(grasps[i]);
  }
  save_closed_poses(file, closed);
  return file;
}

GraspPose closed_pose(const Grasp& grasp, const Hand& hand) {
  const std::filesystem::path file = closed_poses_file(grasp, hand);
  if (!std::filesystem::exists(file)) return close_grasp(grasp, hand);
  const ClosedPoses closed = load_closed_poses(file);
  const auto hash = closed.grasp_hashes.find(grasp.id);
  const bool same_grasp = hash != closed.grasp_hashes.end() && hash->second == grasp_hash(grasp);
  return is_of(closed, hand) && same_grasp ? closed.poses.at(grasp.id) : close_grasp(grasp, hand);
}

}  // namespace graspdb
