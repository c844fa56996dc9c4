// SPDX-License-Identifier: MIT
#include "graspdb/generator/posed_scene.h"

#include <algorithm>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

// Metres, about a finger and a half.
constexpr double kOpennessReach = 0.03;

Mesh transformed(const Mesh& mesh, const RigidTransform& target_from_mesh) {
  Mesh moved = mesh;
  const Eigen::Matrix3f rotation = target_from_mesh.rotation.cast<float>();
  const Eigen::Vector3f translation = target_from_mesh.translation.cast<float>();
  for (Eigen::Vector3f& vertex : moved.vertices) vertex = rotation * vertex + translation;
  for (Eigen::Vector3f& normal : moved.normals) normal = rotation * normal;
  return moved;
}

}  // namespace

Hand with_visible_forearm(Hand hand, double length) {
  GRASPDB_CHECK(length >= 0);
  const RigidTransform& hand_from_forearm = hand.hand_from_bone_at_bind[kForearm];
  const RigidTransform forearm_from_hand = hand_from_forearm.inverse();
  double end = length;
  for (const Eigen::Vector3f& vertex : hand.bind_mesh.vertices) {
    end = std::max(end, -(forearm_from_hand * vertex.cast<double>()).y());
  }
  const Eigen::Vector3f proximal = -hand_from_forearm.rotation.col(1).cast<float>();
  for (std::size_t v = 0; v < hand.bind_mesh.vertices.size(); ++v) {
    Eigen::Vector3f& vertex = hand.bind_mesh.vertices[v];
    Eigen::Vector3d in_forearm = forearm_from_hand * vertex.cast<double>();
    const double beyond = -length - in_forearm.y();
    if (beyond <= 0) continue;
    // Towards the axis, so that an arm that grows wider leaves no rim.
    const double towards_axis = 1 - beyond / (end - length);
    in_forearm = {in_forearm.x() * towards_axis, -length, in_forearm.z() * towards_axis};
    vertex = (hand_from_forearm * in_forearm).cast<float>();
    hand.bind_mesh.normals[v] = proximal;
  }
  return hand;
}

PosedScene pose_scene(const Hand& hand, const GraspPose& pose, const Solid* object,
                      int openness_rays) {
  Mesh skin = pose_skin(hand, pose.angles);
  Mesh solid;
  if (object != nullptr) solid = transformed(object->mesh(), pose.hand_from_object);
  const Mesh* held = object != nullptr ? &solid : nullptr;
  const std::vector<float> openness = ambient_openness(skin, held, openness_rays, kOpennessReach);
  Scene scene(skin, strongest_bones(hand), held, openness);
  return {std::move(scene), std::move(skin.vertices), palm_center(hand.skeleton, pose.angles)};
}

}  // namespace graspdb
