// SPDX-License-Identifier: MIT
#include "crossing.h"

#include <algorithm>

#include "skin_samples.h"

namespace graspdb {
namespace {

Eigen::Vector3d gradient(const Solid& solid, const Eigen::Vector3d& at) {
  constexpr double kStep = 1e-5;  // metres
  Eigen::Vector3d slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    slope[axis] = (solid.distance(at + step) - solid.distance(at - step)) / (2 * kStep);
  }
  return slope;
}

// The middle of the flesh under some skin of a bone: on the bone's axis, but not in its ends, which
// are as near to the skin before them as to that beside them.
Eigen::Vector3d middle_of_flesh(const Eigen::Vector3d& skin_in_bone, const Eigen::Vector3d& end) {
  constexpr double kFirst = 0.1, kLast = 0.7;
  return std::clamp(skin_in_bone.dot(end) / end.squaredNorm(), kFirst, kLast) * end;
}

std::vector<Eigen::Vector3d> skin_in_object(const Hand& hand, const GraspPose& pose) {
  const RigidTransform object_from_hand = pose.hand_from_object.inverse();
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& v : pose_skin(hand, pose.angles).vertices) {
    points.emplace_back(object_from_hand * v.cast<double>());
  }
  return points;
}

void add_crossing(const Solid& solid, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                  double& deepest) {
  if (passes_through(solid, from, to)) deepest = std::max(deepest, solid.distance(to));
}

}  // namespace

bool passes_through(const Solid& solid, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double kFacing = 0.5;      // cosine between the way and the sides of the object
  constexpr double kOpposite = -0.7;   // ... and between the two sides
  constexpr double kFinest = 0.02e-3;  // metres
  const double length = (to - from).norm();
  const double before = solid.distance(from), behind = solid.distance(to);
  if (before <= 0 || behind <= 0 || before + behind >= length) return false;
  const Eigen::Vector3d way = (to - from) / length;
  const Eigen::Vector3d front = gradient(solid, from), back = gradient(solid, to);
  if (front.dot(way) > -kFacing || back.dot(way) < kFacing || front.dot(back) > kOpposite) {
    return false;
  }
  for (double along = before; along < length - behind;) {
    const double distance = solid.distance(from + along * way);
    if (distance < 0) return true;
    along += std::max(distance, kFinest);
  }
  return false;
}

CrossingDepths crossed_skin(const Grasp& grasp, const Hand& hand, const GraspPose& pose,
                            const Mesh& skin, const std::vector<int>& digit) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const PerBone<RigidTransform> posed = hand_from_bones(hand.skeleton, pose.angles);
  const RigidTransform object_from_hand = pose.hand_from_object.inverse();
  CrossingDepths depths{};
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (digit[v] < 1) continue;
    const RigidTransform& hand_from_bone = posed[bones[v]];
    const Eigen::Vector3d at = skin.vertices[v].cast<double>();
    const Eigen::Vector3d flesh =
        middle_of_flesh(hand_from_bone.inverse() * at, bone_end(hand.skeleton, bones[v]));
    add_crossing(*grasp.object, object_from_hand * (hand_from_bone * flesh), object_from_hand * at,
                 depths[static_cast<std::size_t>(digit[v])]);
  }
  return depths;
}

CrossingDepths crossed_on_the_way(const Grasp& grasp, const Hand& hand, const JointAngles& rest,
                                  const GraspPose& closed, int step,
                                  const std::vector<int>& digit) {
  constexpr int kParts = 3;  // of a step: skin moves nearly straight in each
  CrossingDepths depths{};
  std::vector<Eigen::Vector3d> from;
  for (int part = 0; part <= kParts; ++part) {
    const int at = (step - 1) * kParts + part;
    const std::vector<Eigen::Vector3d> to =
        skin_in_object(hand, pose_at_step(grasp, rest, closed, at, kStepCount * kParts));
    for (std::size_t v = 0; part > 0 && v < to.size(); ++v) {
      if (digit[v] < 0) continue;
      add_crossing(*grasp.object, from[v], to[v], depths[static_cast<std::size_t>(digit[v])]);
    }
    from = to;
  }
  return depths;
}

}  // namespace graspdb
