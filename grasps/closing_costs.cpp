// SPDX-License-Identifier: MIT
// The terms of a grasp's cost. One unit is what a gap of a millimetre costs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "closing_problem.h"

namespace graspdb {
namespace {

// Pulls hard when near and evenly when far, so that one phalanx that cannot reach does not pull the
// object out of the hand.
double robust_gap(double gap_mm) {
  constexpr double kNear = 4;
  const double ratio = gap_mm / kNear;
  return std::copysign(kNear * std::sqrt(2 * (std::sqrt(1 + ratio * ratio) - 1)), gap_mm);
}

bool is_pulp(const ContactArea& area) {
  return area.name.starts_with("pulp") || area.name.starts_with("tip");
}

// How far each angle may leave its start for one unit, radians.
double angle_tolerance(int angle) {
  if (angle < kFirstFingerAngle) return radians(angle == kThumbMcpAbduction ? 5 : 12);
  switch ((angle - kFirstFingerAngle) % 5) {
    case kCmcFlexion:
      return radians(6);
    case kMcpAbduction:
      return radians(5);
    default:
      return radians(14);
  }
}

void add_vector(const Eigen::Vector3d& v, std::vector<double>& r) {
  r.insert(r.end(), {v.x(), v.y(), v.z()});
}

}  // namespace

// For each area the gap of its nearest skin, and how well the area faces the object. What must hold
// a thing with the pulps alone must not miss it; of many phalanges one may.
void ClosingProblem::add_contacts(const Posed& posed, Costs& r) const {
  constexpr double kGoal = -0.2e-3;  // metres: skin gives way a little
  constexpr double kPulpWeight = 3, kFacingWeight = 2;
  for (const auto& [area, samples] : areas_) {
    double gap = std::numeric_limits<double>::max();
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const int i : samples) {
      gap = std::min(gap, posed.distance[static_cast<std::size_t>(i)]);
      center += posed.in_object[static_cast<std::size_t>(i)] / static_cast<double>(samples.size());
    }
    r.push_back((is_pulp(area) ? kPulpWeight : 1) *
                robust_gap((gap - kGoal) * kMillimetersPerMeter));
    const Eigen::Vector3d facing =
        posed.object_from_hand.rotation *
        (posed.bones[static_cast<std::size_t>(area.bone)].rotation * outward(area.side));
    add_vector(kFacingWeight * (facing + away_from_object(area.digit, center)), r);
  }
}

void ClosingProblem::add_penetration(const Posed& posed, Costs& r) const {
  constexpr double kSoftTissue = 0.5e-3;  // metres
  constexpr double kWeight = 3;
  for (const double distance : posed.distance) {
    r.push_back(kWeight * std::max(0.0, -distance - kSoftTissue - give_) * kMillimetersPerMeter);
  }
}

void ClosingProblem::add_free_digits(const Posed& posed, Costs& r) const {
  constexpr double kClearance = 5e-3;  // metres
  for (const int digit : grasp_.free_digits) {
    double gap = kClearance;
    for (std::size_t i = 0; i < posed.distance.size(); ++i) {
      if (skin_.samples()[i].digit == digit) gap = std::min(gap, posed.distance[i]);
    }
    r.push_back((kClearance - gap) * kMillimetersPerMeter);
  }
}

void ClosingProblem::add_overlaps(const Posed& posed, Costs& r) const {
  constexpr double kMargin = 0.3e-3;  // metres: capsules are round, fingers are not
  constexpr double kWeight = 3;
  const PerBone<DigitCapsule> capsules = capsules_.pose(posed.bones);
  for (const auto& [a, b] : pairs_) {
    const double overlap = -graspdb::distance(capsules[static_cast<std::size_t>(a)],
                                              capsules[static_cast<std::size_t>(b)]);
    r.push_back(kWeight * std::max(0.0, overlap + kMargin - give_) * kMillimetersPerMeter);
  }
}

// Thumb and fingers press against each other, not past each other.
void ClosingProblem::add_opposition(const Posed& posed, Costs& r) const {
  constexpr double kTolerance = 2e-3;  // metres
  if (!grasp_.from_contacts) return;
  const Opposed contacts = opposed_contacts(posed);
  const Eigen::Vector3d pressing = posed.object_from_hand.rotation *
                                   posed.bones[kThumbDistal].rotation * outward(SkinSide::kPalmar);
  const Eigen::Vector3d across = contacts.others - contacts.thumb;
  add_vector((across - across.dot(pressing) * pressing) / kTolerance, r);
}

// The file's angles, joints of a finger that bend together, fingers that bend and spread alike, and
// the ranges.
void ClosingProblem::add_angle_priors(const Eigen::VectorXd& x, const JointAngles& angles,
                                      Costs& r) const {
  const JointAngles left = angles - start_.angles;
  for (int i = kThumbCmcFlexion; i < kAngleCount; ++i) {
    r.push_back(left[i] / angle_tolerance(i));
    r.push_back((x[i - kThumbCmcFlexion] - angles[i]) / radians(2));
  }
  const auto moved = [&](int finger, FingerAngle angle) {
    return left[finger_angle(finger, angle)];
  };
  for (int f = 0; f < kFingerCount; ++f) {
    const double mcp = moved(f, kMcpFlexion), pip = moved(f, kPipFlexion);
    r.push_back((moved(f, kDipFlexion) - 0.55 * pip) / radians(8));
    r.push_back((mcp - 0.9 * pip) / radians(20));
    if (f + 1 == kFingerCount) continue;
    r.push_back((mcp - moved(f + 1, kMcpFlexion)) / radians(12));
    r.push_back((pip - moved(f + 1, kPipFlexion)) / radians(12));
    r.push_back((moved(f, kMcpAbduction) - moved(f + 1, kMcpAbduction)) / radians(4));
  }
}

// The object stays near its place: in the hand or, for what is held between thumb and fingers,
// between these.
void ClosingProblem::add_placement_priors(const Eigen::VectorXd& x, const Posed& posed,
                                          Costs& r) const {
  constexpr double kInHand = 0.8, kBetweenContacts = 0.4;  // centimetres, as the unknowns
  Eigen::Vector3d left = x.segment<3>(x.size() - 6) / kInHand;
  if (grasp_.from_contacts) {
    const Eigen::Vector3d contacts_to_object =
        posed.object_from_hand.rotation.transpose() * -opposed_contacts(posed).middle();
    left = (contacts_to_object - contacts_to_object_) * 100 / kBetweenContacts;
  }
  add_vector(left, r);
  add_vector(x.tail<3>() / radians(15), r);
}

}  // namespace graspdb
