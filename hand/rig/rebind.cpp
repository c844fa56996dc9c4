// SPDX-License-Identifier: MIT
#include "rebind.h"

#include <Eigen/Geometry>

namespace graspdb {
namespace {

using Eigen::Quaterniond;

struct DualQuaternion {
  Quaterniond real, dual;
};

DualQuaternion dual_quaternion(const RigidTransform& transform) {
  const Quaterniond real(transform.rotation);
  const Eigen::Vector3d half = .5 * transform.translation;
  return {real, Quaterniond(0, half.x(), half.y(), half.z()) * real};
}

RigidTransform blend(const SkinWeights& skin, const PerBone<DualQuaternion>& of_bone) {
  const Quaterniond& first = of_bone[skin.bone[0]].real;
  Eigen::Vector4d real = Eigen::Vector4d::Zero(), dual = real;
  for (std::size_t i = 0; i < 4; ++i) {
    const DualQuaternion& q = of_bone[skin.bone[i]];
    // Of the two quaternions of a rotation the one that is nearer to the first bone's.
    const double weight = q.real.dot(first) < 0 ? -skin.weight[i] : skin.weight[i];
    real += weight * q.real.coeffs();
    dual += weight * q.dual.coeffs();
  }
  const Quaterniond rotation(real / real.norm()), moved(dual / real.norm());
  return {rotation.toRotationMatrix(), 2 * (moved * rotation.conjugate()).vec()};
}

// About the middles of the ranges that hands use.
JointAngles half_bent() {
  JointAngles angles = JointAngles::Zero();
  for (int finger = 0; finger < kFingerCount; ++finger) {
    angles[finger_angle(finger, kMcpFlexion)] = radians(12);
    angles[finger_angle(finger, kPipFlexion)] = radians(60);
    angles[finger_angle(finger, kDipFlexion)] = radians(40);
  }
  angles[kThumbCmcFlexion] = radians(20);
  angles[kThumbCmcAbduction] = radians(15);
  angles[kThumbCmcAxial] = radians(30);
  angles[kThumbMcpFlexion] = radians(20);
  angles[kThumbIpFlexion] = radians(25);
  return angles;
}

}  // namespace

Hand bound_half_bent(Hand hand) {
  const PerBone<RigidTransform> bent = hand_from_bones(hand.skeleton, half_bent());
  PerBone<DualQuaternion> bent_from_bind;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    bent_from_bind[bone] =
        dual_quaternion(bent[bone] * hand.hand_from_bone_at_bind[bone].inverse());
  }
  for (std::size_t v = 0; v < hand.weights.size(); ++v) {
    const RigidTransform moved = blend(hand.weights[v], bent_from_bind);
    Eigen::Vector3f &vertex = hand.bind_mesh.vertices[v], &normal = hand.bind_mesh.normals[v];
    vertex = (moved * vertex.cast<double>()).cast<float>();
    normal = moved.rotation.cast<float>() * normal;
  }
  hand.hand_from_bone_at_bind = bent;
  return hand;
}

}  // namespace graspdb
