// SPDX-License-Identifier: MIT
#include "fit.h"

#include <algorithm>
#include <cmath>

#include "proportions.h"

namespace graspdb {
namespace {

// How far the flesh reaches from a point inside it.
double reach_mm(const HandSurface& surface, const Eigen::Vector3d& inside,
                const Eigen::Vector3d& direction) {
  double reach = 0;
  for (int step = 0; step < 100; ++step) {
    const double left = -surface.distance(inside + reach * direction);
    reach += left;
    if (std::abs(left) < 1e-4) break;
  }
  return reach;
}

double extent_mm(const HandSurface& surface, const Eigen::Vector3d& inside,
                 const Eigen::Vector3d& direction) {
  return reach_mm(surface, inside, direction) + reach_mm(surface, inside, -direction);
}

// The widest of the sections at several heights on both sides of a joint.
double breadth_mm(const HandSurface& surface, const RigidTransform& joint, double lowest,
                  double highest) {
  double widest = 0;
  for (int i = 0; i <= 8; ++i) {
    const double height = std::lerp(lowest, highest, i / 8.0);
    widest = std::max(
        widest, extent_mm(surface, joint * Eigen::Vector3d(0, 0, height), joint.rotation.col(0)));
  }
  return widest;
}

// Along the line through the outer two knuckles.
double knuckle_breadth_mm(const HandSurface& surface, const BoneFramesMm& frames, double width) {
  const Eigen::Vector3d index = frames[finger_bone(0, kProximal)].translation;
  const Eigen::Vector3d little = frames[finger_bone(3, kProximal)].translation;
  const Eigen::Vector3d across = (little - index).normalized();
  double outwards = 0, inwards = 0;
  for (int height = -12; height <= 6; height += 2) {
    const Eigen::Vector3d up(0, 0, height * width);
    outwards = std::max(outwards, reach_mm(surface, little + up, across));
    inwards = std::max(inwards, reach_mm(surface, index + up, -across));
  }
  return (little - index).norm() + outwards + inwards;
}

// The palm is a little thinner when the thumb lies flat than in the bind pose.
constexpr double kFlatPerBoundThickness = .975;

double palm_thickness_mm(const HandSurface& surface, const BoneFramesMm& frames) {
  const RigidTransform& bone = frames[finger_bone(1, kMetacarpal)];
  const Eigen::Vector3d knuckle = frames[finger_bone(1, kProximal)].translation;
  const Eigen::Vector3d middle = .5 * (bone.translation + knuckle);
  return kFlatPerBoundThickness * extent_mm(surface, middle, Eigen::Vector3d::UnitZ());
}

double forearm_breadth_mm(const HandSurface& surface, const HandShape& shape) {
  const RigidTransform behind{Eigen::Matrix3d::Identity(),
                              Eigen::Vector3d(0, -shape.length_mm / 8, 0)};
  return breadth_mm(surface, behind, -12, 6);
}

}  // namespace

BoneFramesMm bind_frames_mm(const Skeleton& skeleton) {
  BoneFramesMm frames = hand_from_bones(skeleton, bind_angles());
  for (RigidTransform& frame : frames) frame.translation *= 1000;
  return frames;
}

HandSurface surface_of_shape(const HandShape& shape, const FleshScales& scales) {
  const Skeleton skeleton = skeleton_of_shape(shape, scales.width);
  std::array<Eigen::Vector3d, 5> tips = skeleton.tip_in_distal;
  for (Eigen::Vector3d& tip : tips) tip *= 1000;
  return {flesh_of_shape(shape, scales, bind_frames_mm(skeleton), tips), scales.width,
          shape.forearm_length_mm};
}

FleshScales fitting_scales(const HandShape& shape) {
  FleshScales scales{shape.breadth_mm / kTableBreadthMm,
                     shape.finger_breadth_mm / kTableFingerBreadthMm,
                     shape.palm_thickness_mm / kTablePalmThicknessMm,
                     shape.forearm_breadth_mm / kTableForearmBreadthMm};
  for (int step = 0; step < 8; ++step) {
    const HandSurface surface = surface_of_shape(shape, scales);
    const BoneFramesMm frames = bind_frames_mm(skeleton_of_shape(shape, scales.width));
    const RigidTransform& pip = frames[finger_bone(0, kMiddle)];
    scales.width *= shape.breadth_mm / knuckle_breadth_mm(surface, frames, scales.width);
    scales.digit *= shape.finger_breadth_mm / breadth_mm(surface, pip, -6, 3);
    scales.palm *= shape.palm_thickness_mm / palm_thickness_mm(surface, frames);
    scales.forearm *= shape.forearm_breadth_mm / forearm_breadth_mm(surface, shape);
  }
  return scales;
}

}  // namespace graspdb
