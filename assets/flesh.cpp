// SPDX-License-Identifier: MIT
#include "flesh.h"

#include "graspdb/transform.h"
#include "proportions.h"

namespace graspdb {
namespace {

// Radii for a breadth of 86 mm: at the MCP joint, mid-proximal, PIP, mid-middle, DIP, tip; the
// thumb without the middle phalanx.
constexpr double kFingerRadii[kFingerCount][6] = {{10.4, 9.7, 9.0, 8.5, 7.9, 6.7},
                                                  {10.4, 9.8, 9.1, 8.6, 8.0, 6.8},
                                                  {9.9, 9.2, 8.6, 8.1, 7.6, 6.4},
                                                  {8.9, 8.1, 7.5, 7.1, 6.6, 5.7}};

// Adds capsules given in the frame of one bone, in table millimetres.
class Builder {
 public:
  Builder(Flesh& flesh, const RigidTransform& frame, double scale)
      : flesh_(flesh), frame_(frame), scale_(scale) {}

  // Positions in real millimetres in the bone's frame, radii in table millimetres.
  void add(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double start_radius,
           double end_radius, double start_depth = 1, double end_depth = 1) {
    flesh_.capsules.push_back({frame_ * start, frame_ * end, start_radius * scale_,
                               end_radius * scale_, frame_.rotation.col(2), start_depth,
                               end_depth});
  }

 private:
  Flesh& flesh_;
  const RigidTransform& frame_;
  double scale_;
};

class Maker {
 public:
  Maker(const HandShape& shape, double width, const BoneFramesMm& frames,
        const std::array<Eigen::Vector3d, 5>& tips_mm)
      : shape_(shape), width_(width), frames_(frames), tips_(tips_mm) {}

  HandFlesh make() {
    for (int finger = 0; finger < kFingerCount; ++finger) add_finger(finger);
    add_thumb();
    flesh_.palm.blend = 7 * width_;
    for (int finger = 0; finger < kFingerCount; ++finger) add_metacarpal(finger);
    add_thenar();
    add_heel();
    for (int finger = 0; finger + 1 < kFingerCount; ++finger) add_web(finger);
    add_forearm();
    return flesh_;
  }

 private:
  const RigidTransform& frame(int bone) const { return frames_[static_cast<std::size_t>(bone)]; }
  double length(int bone) const {
    return (frame(bone + 1).translation - frame(bone).translation).norm();
  }

  // A phalanx from joint to joint: a shaft, and the pad on its palmar side. The gaps between the
  // pads are the flexion creases.
  void add_phalanx(Flesh& flesh, int bone, double length, const double* radii, double thickness) {
    Builder builder(flesh, frame(bone), thickness);
    const double palmar = -1.2 * thickness, r = radii[1] * thickness;
    builder.add({0, 0, palmar}, {0, .5 * length, palmar}, radii[0], radii[1], .94, .93);
    builder.add({0, .5 * length, palmar}, {0, length, palmar}, radii[1], radii[2], .93, .94);
    builder.add({0, .30 * length, palmar - .32 * r}, {0, .66 * length, palmar - .30 * r},
                .76 * radii[1], .74 * radii[1]);
  }

  void add_tip(Flesh& flesh, int bone, double length, double joint_radius, double tip_radius,
               double thickness) {
    Builder builder(flesh, frame(bone), thickness);
    const double palmar = -1.2 * thickness, r = tip_radius * thickness;
    builder.add({0, 0, palmar}, {0, length - r, palmar}, joint_radius, tip_radius, .93, .82);
    builder.add({0, .42 * length, palmar - .28 * r}, {0, length - 1.15 * r, palmar - .12 * r},
                .86 * joint_radius, .86 * tip_radius, .95, .95);
  }

  void add_finger(int finger) {
    Flesh& flesh = flesh_.digits[static_cast<std::size_t>(finger + 1)];
    const double thickness = width_ * shape_.finger_thickness;
    flesh.blend = 3.5 * thickness;
    const double* radii = kFingerRadii[finger];
    const Bone proximal = finger_bone(finger, kProximal), middle = finger_bone(finger, kMiddle);
    add_phalanx(flesh, proximal, length(proximal), radii, thickness);
    add_phalanx(flesh, middle, length(middle), radii + 2, thickness);
    add_tip(flesh, finger_bone(finger, kDistal), tips_[static_cast<std::size_t>(finger + 1)].y(),
            radii[4], radii[5], thickness);
  }

  void add_thumb() {
    Flesh& flesh = flesh_.digits[0];
    const double thickness = width_ * shape_.finger_thickness;
    flesh.blend = 4 * thickness;
    const double radii[] = {10.2, 9.6, 9.7};
    add_phalanx(flesh, kThumbProximal, length(kThumbProximal), radii, thickness);
    add_tip(flesh, kThumbDistal, tips_[0].y(), 9.7, 7.6, thickness);
  }

  // One finger's share of the palm: the shaft, a thin dorsal ridge with its knuckle, and the pad
  // under the knuckle.
  void add_metacarpal(int finger) {
    const Bone bone = finger_bone(finger, kMetacarpal);
    const double l = length(bone), thick = width_ * shape_.palm_thickness;
    const double head = kFingerRadii[finger][0];
    Builder builder(flesh_.palm, frame(bone), width_);
    builder.add({0, 0, -4 * thick}, {0, l, -3.5 * thick}, 11.5, head, shape_.palm_thickness,
                shape_.palm_thickness);
    builder.add({0, 0, 1 * thick}, {0, l, 0}, 8, .86 * head);
    builder.add({0, l - 2, .6 * thick}, {0, l, .2 * thick}, .84 * head, .84 * head);
    builder.add({0, l - 14, -7.5 * thick}, {0, l - 1, -7 * thick}, 7.5, 8);
    flesh_.rays[static_cast<std::size_t>(finger + 1)] =
        flesh_.palm.capsules[flesh_.palm.capsules.size() - 4];
  }

  Eigen::Vector3d palm_point(double x, double y, double z) const {
    return {x * width_, y * shape_.length_mm / kTableLengthMm, z * width_ * shape_.palm_thickness};
  }

  void add_between(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double start_radius,
                   double end_radius) {
    flesh_.palm.capsules.push_back({start, end, start_radius * width_, end_radius * width_});
  }

  // The thumb's metacarpal, its muscles, and the first web.
  void add_thenar() {
    const RigidTransform& thumb = frame(kThumbMetacarpal);
    const double l = length(kThumbMetacarpal);
    const auto on_thumb = [&](double along, double z) {
      return Eigen::Vector3d(thumb * Eigen::Vector3d(0, along * l, z * width_));
    };
    add_between(on_thumb(0, -1), on_thumb(1, -1), 10.5, 9.6);
    flesh_.rays[0] = flesh_.palm.capsules.back();
    add_between(palm_point(-9, 20, -11), on_thumb(.72, -5), 13.5, 9.5);
    add_between(palm_point(-4, 30, -11), on_thumb(.55, -5), 12, 9.5);
    const RigidTransform& index = frame(finger_bone(0, kMetacarpal));
    const double index_length = length(finger_bone(0, kMetacarpal));
    const auto on_index = [&](double along) {
      return Eigen::Vector3d(index * Eigen::Vector3d(0, along * index_length, -5 * width_));
    };
    add_between(on_thumb(.45, -1), on_index(.45), 9.5, 10);
    add_between(on_thumb(.80, -1), on_index(.70), 6.5, 8.5);
  }

  // The carpus, and the little finger's muscles on the heel of the hand.
  void add_heel() {
    add_between(palm_point(17, 16, -9), palm_point(31, 56, -9), 11.5, 10);
    flesh_.palm.capsules.push_back({palm_point(-12, 9, -3), palm_point(13, 9, -3), 18 * width_,
                                    18 * width_, Eigen::Vector3d::UnitZ(), shape_.palm_thickness,
                                    shape_.palm_thickness});
  }

  void add_web(int finger) {
    const auto root = [&](int f) {
      const Bone bone = finger_bone(f, kProximal);
      return Eigen::Vector3d(frame(bone) * Eigen::Vector3d(0, .28 * length(bone), -4 * width_));
    };
    add_between(root(finger), root(finger + 1), 6.8, 6.8);
  }

  // Two elliptic cones, the ulna's head and the radius' end. It is cut off by HandSurface.
  void add_forearm() {
    Flesh& flesh = flesh_.forearm;
    flesh.blend = 12 * width_;
    const double thickness = width_ * shape_.forearm_thickness, l = shape_.forearm_length_mm;
    Builder builder(flesh, frame(kForearm), thickness);
    builder.add({0, 2, -1}, {0, -65, -1}, 27, 30, .72, .80);
    builder.add({0, -65, -1}, {0, -l - 30, -1}, 30, 39, .80, .88);
    builder.add({20 * thickness, -16, 7 * thickness}, {19 * thickness, -26, 5 * thickness}, 8, 7);
    builder.add({-17 * thickness, -2, 0}, {-17 * thickness, -16, 0}, 11, 10);
  }

  const HandShape& shape_;
  double width_;
  const BoneFramesMm& frames_;
  const std::array<Eigen::Vector3d, 5>& tips_;
  HandFlesh flesh_;
};

}  // namespace

HandFlesh flesh_of_shape(const HandShape& shape, double width, const BoneFramesMm& frames,
                         const std::array<Eigen::Vector3d, 5>& tips_mm) {
  return Maker(shape, width, frames, tips_mm).make();
}

}  // namespace graspdb
