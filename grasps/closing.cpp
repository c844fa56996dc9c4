// SPDX-License-Identifier: MIT
#include "graspdb/grasps/closing.h"

#include <optional>
#include <vector>

#include "closing_problem.h"
#include "least_squares.h"

namespace graspdb {
namespace {

// Straightens each finger that starts inside the object, and takes the thumb aside, until they are
// clear: closing then comes from outside, where the way to the surface is the right one.
GraspPose opened(const ClosingProblem& problem, GraspPose pose) {
  constexpr double kClear = 0.7e-3;  // metres of penetration that a start may have
  constexpr double kShare = 0.9;
  constexpr int kTries = 20;
  for (int f = 0; f < kFingerCount; ++f) {
    const int finger = with_palm(digit_of_finger(f));
    for (int i = 0; i < kTries && problem.penetration(finger, pose) > kClear; ++i) {
      for (const FingerAngle joint : {kMcpFlexion, kPipFlexion, kDipFlexion}) {
        pose.angles[finger_angle(f, joint)] *= kShare;
      }
    }
  }
  const int thumb = with_palm(0);
  for (int i = 0; i < kTries && problem.penetration(thumb, pose) > kClear; ++i) {
    pose.angles[kThumbCmcFlexion] -= radians(1);
    pose.angles[kThumbCmcAbduction] += radians(2);
    pose.angles[kThumbMcpFlexion] *= kShare;
    pose.angles[kThumbIpFlexion] *= kShare;
    pose.angles = clamp_to_range(pose.angles);
  }
  return pose;
}

// The thumb's way round an object is what goes wrong first: several are tried.
std::vector<GraspPose> with_other_thumbs(const GraspPose& start) {
  std::vector<GraspPose> starts;
  for (const double flexion : {0.0, -15.0, 15.0}) {
    for (const double abduction : {0.0, -10.0, 10.0}) {
      GraspPose& other = starts.emplace_back(start);
      other.angles[kThumbCmcFlexion] += radians(flexion);
      other.angles[kThumbCmcAbduction] += radians(abduction);
      other.angles = clamp_to_range(other.angles);
    }
  }
  return starts;
}

Minimum close_from(const ClosingProblem& problem, const GraspPose& from, int iterations) {
  return minimise([&](const Eigen::VectorXd& x) { return problem.residuals(x); },
                  problem.pack(from), iterations);
}

}  // namespace

Grasp fitted_to(const Hand& hand, Grasp grasp) {
  if (!grasp.object_scales) return grasp;
  grasp.object = scaled(grasp.object, hand_length(hand.skeleton) / kReferenceHandLength);
  grasp.object_scales = false;
  return grasp;
}

GraspPose close_grasp(const Grasp& stated, const Hand& hand) {
  const Grasp grasp = fitted_to(hand, stated);
  constexpr int kYieldingIterations = 20, kCoarseIterations = 60, kFineIterations = 15;
  constexpr int kCoarseStride = 3;
  constexpr double kYielding = 8e-3;  // metres: about the radius of a finger
  // Flesh that yields at first lets thumb, fingers and object sort out who passes on which side.
  const ClosingProblem yielding(grasp, hand, kCoarseStride, kYielding);
  const ClosingProblem coarse(grasp, hand, kCoarseStride);
  std::optional<Minimum> best;
  const auto try_from = [&](const GraspPose& start) {
    const Minimum found = close_from(coarse, start, kCoarseIterations);
    if (!best || found.cost < best->cost) best = found;
  };
  for (const GraspPose& thumb : with_other_thumbs(coarse.start())) {
    const GraspPose start = grasp.opposition == Opposition::kPalm ? opened(coarse, thumb) : thumb;
    try_from(start);
    // Such flesh would pass the walls of a hollow object.
    if (!grasp.object_file.empty()) continue;
    try_from(yielding.unpack(close_from(yielding, start, kYieldingIterations).x));
  }
  const ClosingProblem fine(grasp, hand, 1);
  return fine.unpack(close_from(fine, coarse.unpack(best->x), kFineIterations).x);
}

}  // namespace graspdb
