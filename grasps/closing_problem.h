// SPDX-License-Identifier: MIT
// What a natural grasp costs: gaps, penetration, overlap of digits, and how far fingers and object
// have left the places that the grasp's file states.
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "digit_capsules.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"
#include "skin_samples.h"

namespace graspdb {

class ClosingProblem {
 public:
  // Looks at one skin vertex in `stride`. Skin may be `give` metres deeper in objects and other
  // digits than it should before that costs. Keeps references to grasp and hand.
  ClosingProblem(const Grasp& grasp, const Hand& hand, int stride, double give = 0);

  // The file's start on this hand.
  const GraspPose& start() const { return start_; }

  // The unknowns are all angles but the wrist's, radians, and the object's translation (10 mm) and
  // rotation vector (radians) away from the start.
  Eigen::VectorXd pack(const GraspPose& pose) const;
  GraspPose unpack(const Eigen::VectorXd& x) const;  // angles outside their range are moved into it

  Eigen::VectorXd residuals(const Eigen::VectorXd& x) const;

  // The deepest skin of a digit in the object, metres; 0 when it is clear.
  double penetration(int digit, const GraspPose& pose) const;

 private:
  struct Area {
    ContactArea area;
    std::vector<int> samples;
  };
  struct Posed {
    PerBone<RigidTransform> bones;
    RigidTransform object_from_hand;
    std::vector<Eigen::Vector3d> in_object;  // skin samples
    std::vector<double> distance;            // of each to the object, metres
  };
  struct Opposed {
    Eigen::Vector3d thumb, others;  // middles of their contact areas, object frame
    Eigen::Vector3d middle() const { return (thumb + others) / 2; }
  };

  void place_between_contacts();
  void find_sides();
  double side_over_face(int digit, const Posed& posed) const;
  Posed pose(const GraspPose& at) const;
  Opposed opposed_contacts(const Posed& posed) const;
  double distance(int digit, const Eigen::Vector3d& point_in_object) const;
  double beyond_wall(const Eigen::Vector3d& skin_in_object, const Eigen::Vector3d& inwards,
                     double gap) const;
  Eigen::Vector3d away_from_object(int digit, const Eigen::Vector3d& point_in_object) const;

  using Costs = std::vector<double>;
  void add_contacts(const Posed& posed, Costs& r) const;
  void add_penetration(const Posed& posed, Costs& r) const;
  void add_free_digits(const Posed& posed, Costs& r) const;
  void add_overlaps(const Posed& posed, Costs& r) const;
  void add_opposition(const Posed& posed, Costs& r) const;
  void add_angle_priors(const Eigen::VectorXd& x, const JointAngles& angles, Costs& r) const;
  void add_placement_priors(const Eigen::VectorXd& x, const Posed& posed, Costs& r) const;

  const Grasp& grasp_;
  const Hand& hand_;
  double give_;
  SkinSamples skin_;
  DigitCapsules capsules_;
  GraspPose start_;
  std::vector<Area> areas_;
  std::vector<std::pair<int, int>> pairs_;  // bones that must not overlap
  Eigen::Vector3d contacts_to_object_;      // from the middle between contacts, hand frame
  Eigen::Index thin_axis_ = 0;
  std::array<double, kPalmAndDigitCount>
      side_{};  // of a thin object: +-1; 0 where it does not matter
};

}  // namespace graspdb
