// SPDX-License-Identifier: MIT
#include "flesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/transform.h"
#include "proportions.h"

namespace graspdb {
namespace {

// Radii in table millimetres: at the MCP joint, mid-proximal, PIP, mid-middle, DIP, tip.
constexpr double kFingerRadii[kFingerCount][6] = {{10.5, 10.2, 9.9, 9.4, 8.9, 7.6},
                                                  {10.5, 10.2, 10.0, 9.5, 9.0, 7.7},
                                                  {10.1, 9.7, 9.4, 8.9, 8.5, 7.3},
                                                  {9.1, 8.6, 8.3, 7.9, 7.5, 6.5}};
// Of the thumb: at the MCP joint, mid-proximal, IP, tip.
constexpr double kThumbRadii[4] = {9.8, 10.2, 10.7, 9.0};
// Of the metacarpals' heads.
constexpr double kHeadRadii[kFingerCount] = {10, 10, 9.6, 8.7};

// Adds capsules given in the frame of one bone.
class Builder {
 public:
  Builder(Flesh& flesh, const RigidTransform& frame, double scale)
      : flesh_(flesh), frame_(frame), scale_(scale) {}

  // Positions in real millimetres in the bone's frame, radii and blend in table millimetres.
  void add(double blend, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
           double start_radius, double end_radius, double start_depth = 1, double end_depth = 1) {
    flesh_.add({frame_ * start, frame_ * end, start_radius * scale_, end_radius * scale_,
                frame_.rotation.col(2), start_depth, end_depth, blend * scale_});
  }

 private:
  Flesh& flesh_;
  const RigidTransform& frame_;
  double scale_;
};

class Maker {
 public:
  Maker(const HandShape& shape, const FleshScales& scales, const BoneFramesMm& frames,
        const std::array<Eigen::Vector3d, 5>& tips_mm)
      : shape_(shape), scales_(scales), frames_(frames), tips_(tips_mm) {}

  HandFlesh make() {
    for (int finger = 0; finger < kFingerCount; ++finger) add_finger(finger);
    add_thumb();
    for (int finger = 0; finger < kFingerCount; ++finger) add_metacarpal(finger);
    for (int finger = 0; finger + 1 < kFingerCount; ++finger) add_web(finger);
    add_thenar();
    add_heel();
    add_forearm();
    return flesh_;
  }

 private:
  static constexpr double kShaftBlend = 1.5;  // along a digit the radii already agree
  static constexpr double kPadBlend = 4;
  static constexpr double kPalmBlend = 7;

  const RigidTransform& frame(int bone) const { return frames_[static_cast<std::size_t>(bone)]; }
  double length(int bone) const {
    return (frame(bone + 1).translation - frame(bone).translation).norm();
  }

  // A phalanx from joint to joint: a shaft, and the pad on its palmar side. The gaps between the
  // pads are the flexion creases.
  void add_phalanx(Flesh& flesh, int bone, const double* radii) {
    const double scale = scales_.digit, l = length(bone);
    const double palmar = -1.2 * scale, r = radii[1] * scale;
    Builder builder(flesh, frame(bone), scale);
    builder.add(kShaftBlend, {0, 0, palmar}, {0, .5 * l, palmar}, radii[0], radii[1], .94, .93);
    builder.add(kShaftBlend, {0, .5 * l, palmar}, {0, l, palmar}, radii[1], radii[2], .93, .94);
    builder.add(kPadBlend, {0, .10 * l, palmar - .42 * r}, {0, .70 * l, palmar - .32 * r},
                .86 * radii[1], .80 * radii[1]);
  }

  // A last phalanx: flatter to its end, with the pulp under it and the nail on it.
  void add_tip(std::size_t digit, int bone, double joint_radius, double tip_radius) {
    Flesh& flesh = flesh_.digits[digit];
    const double l = tips_[digit].y(), scale = scales_.digit, palmar = -1.2 * scale,
                 r = tip_radius * scale;
    Builder builder(flesh, frame(bone), scale);
    builder.add(kShaftBlend, {0, 0, palmar}, {0, .5 * l, palmar}, joint_radius,
                .5 * (joint_radius + tip_radius) + .2, .93, .88);
    builder.add(kShaftBlend, {0, .5 * l, palmar}, {0, l - r, palmar},
                .5 * (joint_radius + tip_radius) + .2, tip_radius, .88, .80);
    builder.add(kPadBlend, {0, .45 * l, palmar - .26 * r}, {0, l - 1.2 * r, palmar - .12 * r},
                .80 * joint_radius, .84 * tip_radius, .95, .95);
    flesh_.nails[digit] = {frame(bone), l - .82 * r, .76 * r, .72 * r};
  }

  void add_finger(int finger) {
    const auto digit = static_cast<std::size_t>(finger) + 1;
    const double* radii = kFingerRadii[finger];
    add_phalanx(flesh_.digits[digit], finger_bone(finger, kProximal), radii);
    add_phalanx(flesh_.digits[digit], finger_bone(finger, kMiddle), radii + 2);
    add_tip(digit, finger_bone(finger, kDistal), radii[4], radii[5]);
  }

  void add_thumb() {
    add_phalanx(flesh_.digits[0], kThumbProximal, kThumbRadii);
    add_tip(0, kThumbDistal, kThumbRadii[2], kThumbRadii[3]);
  }

  // One finger's share of the palm: the shaft, a thin dorsal ridge with its knuckle, and the pad
  // under the knuckle.
  void add_metacarpal(int finger) {
    const Bone bone = finger_bone(finger, kMetacarpal);
    const double l = length(bone), deep = scales_.palm, depth = scales_.palm / scales_.width;
    const double head = kHeadRadii[finger];
    Builder builder(flesh_.palm, frame(bone), scales_.width);
    builder.add(kPalmBlend, {0, 0, -5 * deep}, {0, l, -4.5 * deep}, 11, .95 * head, depth, depth);
    flesh_.rays[static_cast<std::size_t>(finger) + 1] = flesh_.palm.last();
    builder.add(kPadBlend, {0, 0, 0}, {0, l, -.1 * deep}, 7.5, .86 * head);
    builder.add(kPalmBlend, {0, l - 13, -8.5 * deep}, {0, l - 1, -8.5 * deep}, 8, 8);
  }

  Eigen::Vector3d palm_point(double x, double y, double z) const {
    return {x * scales_.width, y * shape_.length_mm / kTableLengthMm, z * scales_.palm};
  }

  void add_to_palm(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double start_radius,
                   double end_radius) {
    const double width = scales_.width, depth = scales_.palm / width;
    flesh_.palm.add({start, end, start_radius * width, end_radius * width, Eigen::Vector3d::UnitZ(),
                     depth, depth, kPalmBlend * width});
  }

  Eigen::Vector3d on_bone(int bone, double along, double z) const {
    return frame(bone) * Eigen::Vector3d(0, along * length(bone), z * scales_.width);
  }

  // Between two fingers: what fills the gap between their metacarpals, and the web.
  void add_web(int finger) {
    const auto between = [&](FingerBone bone, double along, double z) {
      return Eigen::Vector3d(.5 * (on_bone(finger_bone(finger, bone), along, z) +
                                   on_bone(finger_bone(finger + 1, bone), along, z)));
    };
    add_to_palm(between(kMetacarpal, .12, -4.5), between(kMetacarpal, .95, -4.2), 8.8, 8.4);
    add_to_palm(between(kMetacarpal, .55, -6), between(kMetacarpal, .95, -8), 8, 7.8);
    add_to_palm(between(kProximal, -.05, -2.4), between(kProximal, .22, -3.5), 8.2, 7);
  }

  // The thumb's metacarpal, its muscles, and the first web.
  void add_thenar() {
    const auto on_thumb = [&](double along, double z) {
      return on_bone(kThumbMetacarpal, along, z);
    };
    const auto on_index = [&](double along) {
      return on_bone(finger_bone(0, kMetacarpal), along, -5);
    };
    add_to_palm(on_thumb(0, -1), on_thumb(1, -1), 10, 8.8);
    flesh_.rays[0] = flesh_.palm.last();
    add_to_palm(palm_point(-9, 21, -12), on_thumb(.70, -5), 13, 9.5);
    add_to_palm(palm_point(-4, 30, -12), on_thumb(.55, -5), 12, 9.5);
    add_to_palm(on_thumb(.45, -1), on_index(.45), 9, 9.5);
    add_to_palm(on_thumb(.80, -1), on_index(.68), 6, 8);
    add_to_palm(on_thumb(.92, -1), on_index(.84), 4, 7);
  }

  // The carpus, and the little finger's muscles on the heel of the hand.
  void add_heel() {
    add_to_palm(palm_point(15, 12, -8), palm_point(25, 36, -10), 10.5, 12);
    add_to_palm(palm_point(25, 36, -10), palm_point(34, 60, -8), 12, 10);
    add_to_palm(palm_point(-9, 10, -5), palm_point(10, 10, -5), 13.5, 13.5);
  }

  // Two elliptic cones, the ulna's head and the radius' end. It is cut off by HandSurface.
  void add_forearm() {
    const double scale = scales_.forearm, l = shape_.forearm_length_mm;
    Builder builder(flesh_.forearm, frame(kForearm), scale);
    const double z = -4.5 * scale;
    builder.add(0, {0, -8, z}, {0, -42, z}, 24.5, 26.5, .62, .76);
    builder.add(2, {0, -42, z}, {0, -80, z}, 26.5, 30, .76, .84);
    builder.add(2, {0, -80, z}, {0, -125, z}, 30, 35, .84, .88);
    builder.add(2, {0, -125, z}, {0, -l - 50, z}, 35, 43, .88, .90);
    builder.add(12, {16.5 * scale, -14, 2.5 * scale}, {13 * scale, -65, 0}, 7.5, 7);
    builder.add(12, {-15 * scale, 0, -3 * scale}, {-11 * scale, -65, -3 * scale}, 10.5, 10);
  }

  const HandShape& shape_;
  const FleshScales& scales_;
  const BoneFramesMm& frames_;
  const std::array<Eigen::Vector3d, 5>& tips_;
  HandFlesh flesh_;
};

}  // namespace

double distance_from_nail(const Nail& nail, const Eigen::Vector3d& point) {
  const Eigen::Vector3d local = nail.hand_from_distal.inverse() * point;
  if (local.z() < 0) return std::numeric_limits<double>::infinity();
  const double across = local.x() / nail.half_breadth;
  const double along = (local.y() - nail.middle_y) / nail.half_length;
  return std::pow(std::pow(across, 4) + std::pow(along, 4), .25);
}

HandFlesh flesh_of_shape(const HandShape& shape, const FleshScales& scales,
                         const BoneFramesMm& frames,
                         const std::array<Eigen::Vector3d, 5>& tips_mm) {
  return Maker(shape, scales, frames, tips_mm).make();
}

}  // namespace graspdb
