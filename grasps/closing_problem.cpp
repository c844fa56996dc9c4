// SPDX-License-Identifier: MIT
#include "closing_problem.h"

#include <algorithm>

namespace graspdb {
namespace {

constexpr int kWristAngles = 2;
constexpr int kFreeAngles = kAngleCount - kWristAngles;
constexpr int kUnknowns = kFreeAngles + 6;
constexpr double kTranslationUnit = 0.01;  // metres

bool is_distal(int bone) {
  return is_phalanx(bone) && bone % 4 == kThumbDistal % 4;
}

// Digits overlap digits, and the palm is entered by tips alone.
bool may_overlap(int a, int b) {
  if (is_phalanx(a) && is_phalanx(b)) return digit_of_bone(a) != digit_of_bone(b);
  return digit_of_bone(a) == 0 && a != kPalm && is_distal(b);
}

}  // namespace

ClosingProblem::ClosingProblem(const Grasp& grasp, const Hand& hand, int stride, double give)
    : grasp_(grasp),
      hand_(hand),
      give_(give),
      skin_(hand, stride),
      capsules_(hand),
      start_(grasp.start) {
  for (const ContactArea& area : grasp.contacts) areas_.push_back({area, skin_.in_area(area)});
  for (int a = 0; a < kBoneCount; ++a) {
    for (int b = a + 1; b < kBoneCount; ++b) {
      if (may_overlap(a, b) || may_overlap(b, a)) pairs_.emplace_back(a, b);
    }
  }
  start_.hand_from_object.translation *= hand_length(hand.skeleton) / kReferenceHandLength;
  contacts_to_object_ = start_.hand_from_object.translation;
  if (grasp.from_contacts) place_between_contacts();
  find_sides();
}

void ClosingProblem::place_between_contacts() {
  RigidTransform& placed = start_.hand_from_object;
  placed.translation.setZero();
  placed.translation =
      placed.rotation * opposed_contacts(pose(start_)).middle() + contacts_to_object_;
}

// A finger that has crossed a thin plate is not in it but behind it. So digits keep to the side of
// a thin object where they start.
void ClosingProblem::find_sides() {
  if (!grasp_.object_file.empty()) return;  // a mesh may have holes to reach through
  constexpr double kThin = 0.4;             // share of the second smallest extent
  Eigen::Vector3d extents = grasp_.object->half_extents();
  const double thickness = extents.minCoeff(&thin_axis_);
  extents[thin_axis_] = extents.maxCoeff();
  if (thickness > kThin * extents.minCoeff()) return;
  const Posed posed = pose(start_);
  const Opposed contacts = opposed_contacts(posed);
  const double thumb_side = contacts.thumb[thin_axis_] < contacts.others[thin_axis_] ? -1 : 1;
  std::array<double, kPalmAndDigitCount> sides{};
  for (const int digit : grasp_.required_digits) {
    if (digit == 0) continue;
    sides[static_cast<std::size_t>(digit)] = !grasp_.from_contacts ? side_over_face(digit, posed)
                                             : digit == 1          ? thumb_side
                                                                   : -thumb_side;
  }
  side_ = sides;
}

// The side of the plate whose face all of a digit's contact areas lie over and look at; 0 when
// there is none, as for a finger that goes round the rim.
double ClosingProblem::side_over_face(int digit, const Posed& posed) const {
  constexpr double kLooksAt = 0.7;  // cosine
  double side = 0;
  for (const auto& [area, samples] : areas_) {
    if (area.digit != digit) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int i : samples) middle += posed.in_object[static_cast<std::size_t>(i)];
    middle /= static_cast<double>(std::max<std::size_t>(1, samples.size()));
    const Eigen::Vector3d looks =
        posed.object_from_hand.rotation *
        (posed.bones[static_cast<std::size_t>(area.bone)].rotation * outward(area.side));
    const double here = middle[thin_axis_] < 0 ? -1 : 1;
    middle[thin_axis_] = 0;
    const bool over_face = grasp_.object->distance(middle) < 0;
    if (!over_face || -here * looks[thin_axis_] < kLooksAt || side == -here) return 0;
    side = here;
  }
  return side;
}

Eigen::VectorXd ClosingProblem::pack(const GraspPose& pose) const {
  Eigen::VectorXd x(kUnknowns);
  const RigidTransform& placed = pose.hand_from_object;
  const RigidTransform& at_start = start_.hand_from_object;
  x.head<kFreeAngles>() = pose.angles.tail<kFreeAngles>();
  x.segment<3>(kFreeAngles) = (placed.translation - at_start.translation) / kTranslationUnit;
  x.tail<3>() = vector_from_rotation(placed.rotation * at_start.rotation.transpose());
  return x;
}

GraspPose ClosingProblem::unpack(const Eigen::VectorXd& x) const {
  GraspPose pose = start_;
  pose.angles.tail<kFreeAngles>() = x.head<kFreeAngles>();
  pose.angles = clamp_to_range(pose.angles);
  pose.hand_from_object.translation += kTranslationUnit * x.segment<3>(kFreeAngles);
  pose.hand_from_object.rotation =
      rotation_from_vector(x.tail<3>()) * start_.hand_from_object.rotation;
  return pose;
}

ClosingProblem::Posed ClosingProblem::pose(const GraspPose& at) const {
  Posed posed;
  posed.bones = hand_from_bones(hand_.skeleton, at.angles);
  posed.object_from_hand = at.hand_from_object.inverse();
  posed.in_object = skin_.pose(posed.bones);
  posed.distance.reserve(posed.in_object.size());
  const bool may_be_hollow = !grasp_.object_file.empty();
  for (std::size_t i = 0; i < posed.in_object.size(); ++i) {
    const SkinSamples::Sample& sample = skin_.samples()[i];
    posed.in_object[i] = posed.object_from_hand * posed.in_object[i];
    double gap = distance(sample.digit, posed.in_object[i]);
    if (may_be_hollow) {
      const auto& bone = posed.bones[static_cast<std::size_t>(sample.bone)].rotation;
      const Eigen::Vector3d inwards = posed.object_from_hand.rotation * (bone * -sample.normal);
      gap = std::min(gap, beyond_wall(posed.in_object[i], inwards, gap));
    }
    posed.distance.push_back(gap);
  }
  return posed;
}

// Skin that has passed the wall of a cup is outside the cup again. But then the wall is in the
// flesh under that skin.
double ClosingProblem::beyond_wall(const Eigen::Vector3d& skin, const Eigen::Vector3d& inwards,
                                   double gap) const {
  constexpr double kLayer = 2e-3, kDeepest = 8.5e-3;  // metres: about the radius of a finger
  constexpr double kSure = 1e-3;  // metres in the wall, for a cost without jumps
  double beyond = gap;
  for (double depth = kLayer; depth < kDeepest; depth += kLayer) {
    if (depth <= gap) continue;  // no surface is so near
    const double in_wall = -grasp_.object->distance(skin + depth * inwards);
    if (in_wall > 0) beyond = std::min(beyond, -in_wall - depth * std::min(1.0, in_wall / kSure));
  }
  return beyond;
}

ClosingProblem::Opposed ClosingProblem::opposed_contacts(const Posed& posed) const {
  std::array<Eigen::Vector3d, 2> sum = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::array<int, 2> count = {0, 0};
  for (const Area& area : areas_) {
    const std::size_t side = area.area.digit == 1 ? 0 : 1;
    for (const int i : area.samples) sum[side] += posed.in_object[static_cast<std::size_t>(i)];
    count[side] += static_cast<int>(area.samples.size());
  }
  return {sum[0] / std::max(1, count[0]), sum[1] / std::max(1, count[1])};
}

double ClosingProblem::distance(int digit, const Eigen::Vector3d& point) const {
  const double direct = grasp_.object->distance(point);
  const double side = side_[static_cast<std::size_t>(digit)];
  if (side == 0) return direct;
  Eigen::Vector3d flat = point;
  flat[thin_axis_] = 0;
  if (grasp_.object->distance(flat) > 0) return direct;  // beside the plate
  return side * point[thin_axis_] - grasp_.object->half_extents()[thin_axis_];
}

Eigen::Vector3d ClosingProblem::away_from_object(int digit, const Eigen::Vector3d& point) const {
  constexpr double kStep = 1e-5;  // metres
  Eigen::Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    gradient[axis] = (distance(digit, point + step) - distance(digit, point - step)) / (2 * kStep);
  }
  return gradient;
}

double ClosingProblem::penetration(int digit, const GraspPose& at) const {
  const Posed posed = pose(at);
  double deepest = 0;
  for (std::size_t i = 0; i < posed.distance.size(); ++i) {
    if (skin_.samples()[i].digit == digit) deepest = std::max(deepest, -posed.distance[i]);
  }
  return deepest;
}

Eigen::VectorXd ClosingProblem::residuals(const Eigen::VectorXd& x) const {
  const GraspPose at = unpack(x);
  const Posed posed = pose(at);
  Costs r;
  r.reserve(posed.distance.size() + 512);
  add_contacts(posed, r);
  add_penetration(posed, r);
  add_free_digits(posed, r);
  add_overlaps(posed, r);
  add_opposition(posed, r);
  add_angle_priors(x, at.angles, r);
  add_placement_priors(x, posed, r);
  return Eigen::Map<Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size()));
}

}  // namespace graspdb
