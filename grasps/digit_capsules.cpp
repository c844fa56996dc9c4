// SPDX-License-Identifier: MIT
#include "digit_capsules.h"

#include <algorithm>

#include "graspdb/geometry/triangle.h"
#include "skin_samples.h"

namespace graspdb {
namespace {

Eigen::Vector3d point_at(const DigitCapsule& capsule, double t) {
  return capsule.start + t * (capsule.end - capsule.start);
}

}  // namespace

double distance(const DigitCapsule& capsule, const Eigen::Vector3d& point) {
  return distance_to_segment(point, capsule.start, capsule.end) - capsule.radius;
}

// Ericson, Real-Time Collision Detection, 5.1.9: nearest points of two segments.
double distance(const DigitCapsule& a, const DigitCapsule& b) {
  const Eigen::Vector3d along_a = a.end - a.start, along_b = b.end - b.start;
  const Eigen::Vector3d between = a.start - b.start;
  const double aa = along_a.squaredNorm(), bb = along_b.squaredNorm(), ab = along_a.dot(along_b);
  const double determinant = aa * bb - ab * ab;
  double s = 0;
  if (determinant > 1e-12 * aa * bb) {
    s = std::clamp((ab * along_b.dot(between) - bb * along_a.dot(between)) / determinant, 0.0, 1.0);
  }
  const double t = share_of_way(point_at(a, s), b.start, b.end);
  s = share_of_way(point_at(b, t), a.start, a.end);
  return (point_at(a, s) - point_at(b, t)).norm() - a.radius - b.radius;
}

DigitCapsules::DigitCapsules(const Hand& hand) {
  const std::vector<std::uint8_t> strongest = strongest_bones(hand);
  for (std::size_t bone = kThumbMetacarpal; bone < kBoneCount; ++bone) {
    const RigidTransform bone_from_hand = hand.hand_from_bone_at_bind[bone].inverse();
    const Eigen::Vector3d end = bone_end(hand.skeleton, static_cast<int>(bone));
    std::vector<Eigen::Vector2d> across;  // of the skin round the middle of the bone
    for (std::size_t v = 0; v < strongest.size(); ++v) {
      if (strongest[v] != bone) continue;
      const Eigen::Vector3d p = bone_from_hand * hand.bind_mesh.vertices[v].cast<double>();
      if (p.y() > 0.2 * end.y() && p.y() < 0.8 * end.y()) across.emplace_back(p.x(), p.z());
    }
    if (across.empty()) continue;
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : across) center += p / static_cast<double>(across.size());
    double radius = 0;
    for (const Eigen::Vector2d& p : across) {
      radius += (p - center).norm() / static_cast<double>(across.size());
    }
    const Eigen::Vector3d shift(center.x(), 0, center.y());
    const bool last = bone % 4 == kThumbDistal % 4;  // so are those of the fingers
    const double tip = last ? std::max(0.0, 1 - radius / end.norm()) : 1.0;
    in_bone_[bone] = {shift, tip * end + shift, radius};
  }
}

PerBone<DigitCapsule> DigitCapsules::pose(const PerBone<RigidTransform>& hand_from_bone) const {
  PerBone<DigitCapsule> posed;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    posed[bone] = {hand_from_bone[bone] * in_bone_[bone].start,
                   hand_from_bone[bone] * in_bone_[bone].end, in_bone_[bone].radius};
  }
  return posed;
}

}  // namespace graspdb
