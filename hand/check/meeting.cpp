// SPDX-License-Identifier: MIT
#include "meeting.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "graspdb/core/random.h"
#include "lines.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

// Distance of the pulps and the sum of their directions, which is 0 when they face each other, in
// parts of the gates.
using Misses = Eigen::Matrix<double, 6, 1>;

struct Pulp {
  Vector3d place, palmar;  // hand frame
};

Misses misses_of(const Pulp& thumb, const Pulp& finger) {
  Misses misses;
  misses << (thumb.place - finger.place) / kGapGate,
      (thumb.palmar + finger.palmar) / (2 * std::sin(kFacingGate / 2));
  return misses;
}

Meeting meeting_of(const Pulp& thumb, const Pulp& finger) {
  return {(thumb.place - finger.place).norm(),
          std::acos(std::clamp(-thumb.palmar.dot(finger.palmar), -1.0, 1.0))};
}

struct Candidate {
  JointAngles angles;
  double cost = std::numeric_limits<double>::infinity();  // of its misses, squared
};

constexpr int kThumbAngles = kFirstFingerAngle - kThumbCmcFlexion, kMoved = kThumbAngles + 5;
using Jacobian = Eigen::Matrix<double, 6, kMoved>;

class MeetingSearch {
 public:
  MeetingSearch(const Skeleton& skeleton, const DigitPulp& thumb, const DigitPulp& finger)
      : skeleton_(skeleton), thumb_(thumb), finger_(finger) {
    const auto after_thumb = angles_.begin() + kThumbAngles;
    std::iota(angles_.begin(), after_thumb, static_cast<int>(kThumbCmcFlexion));
    std::iota(after_thumb, angles_.end(), finger_angle(finger.digit - 1, kCmcFlexion));
  }

  Meeting find() {
    Meeting best{1, kPi};
    for (const Candidate& pair : best_pairs()) {
      const PerBone<RigidTransform> frames = hand_from_bones(skeleton_, improved(pair).angles);
      const Meeting met = meeting_of(pulp_of(thumb_, frames), pulp_of(finger_, frames));
      if (met.badness() < best.badness()) best = met;
    }
    return best;
  }

 private:
  static constexpr int kSamples = 500, kStarts = 12, kSteps = 30;

  static Pulp pulp_of(const DigitPulp& digit, const PerBone<RigidTransform>& hand_from_bone) {
    const RigidTransform& frame =
        hand_from_bone[static_cast<std::size_t>(distal_bone(digit.digit))];
    return {frame * digit.in_distal, -frame.rotation.col(2)};
  }

  Misses misses(const JointAngles& angles) const {
    const PerBone<RigidTransform> frames = hand_from_bones(skeleton_, angles);
    return misses_of(pulp_of(thumb_, frames), pulp_of(finger_, frames));
  }

  JointAngles drawn() {
    JointAngles angles = JointAngles::Zero();
    for (const int a : angles_) {
      angles[a] = random_.uniform(angle_info(a).lower, angle_info(a).upper);
    }
    return clamp_to_range(angles);
  }

  // Thumb's and finger's angles of two drawings together.
  static JointAngles joined(JointAngles thumb, const JointAngles& finger) {
    thumb.tail<kAngleCount - kFirstFingerAngle>() = finger.tail<kAngleCount - kFirstFingerAngle>();
    return thumb;
  }

  // For every drawn finger the thumb that meets it best; of these the best, best first.
  std::vector<Candidate> best_pairs() {
    std::vector<JointAngles> draws;
    std::vector<Pulp> thumbs;
    for (int i = 0; i < kSamples; ++i) {
      draws.push_back(drawn());
      thumbs.push_back(pulp_of(thumb_, hand_from_bones(skeleton_, draws.back())));
    }
    std::vector<Candidate> pairs;
    for (const JointAngles& draw : draws) {
      const Pulp finger = pulp_of(finger_, hand_from_bones(skeleton_, draw));
      Candidate best;
      for (std::size_t t = 0; t < thumbs.size(); ++t) {
        const double apart = (thumbs[t].place - finger.place).squaredNorm();
        if (apart > kGapGate * kGapGate * best.cost) continue;
        const double cost = misses_of(thumbs[t], finger).squaredNorm();
        if (cost < best.cost) best = {joined(draws[t], draw), cost};
      }
      pairs.push_back(best);
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    pairs.resize(kStarts);
    return pairs;
  }

  // Levenberg and Marquardt's descent among the angles that are not held at the end of their range;
  // a step that leaves the ranges is cut off.
  Candidate improved(Candidate best) const {
    double damping = 1;
    for (int step = 0; step < kSteps; ++step) {
      const Misses here = misses(best.angles);
      Jacobian jacobian = jacobian_at(best.angles, here);
      hold_at_limits(best.angles, here, jacobian);
      Eigen::Matrix<double, kMoved, kMoved> normal = jacobian.transpose() * jacobian;
      normal.diagonal().array() += damping;
      const Eigen::Matrix<double, kMoved, 1> moves =
          normal.ldlt().solve(-jacobian.transpose() * here);
      Candidate other = best;
      for (std::size_t i = 0; i < angles_.size(); ++i) {
        other.angles[angles_[i]] += moves[static_cast<Eigen::Index>(i)];
      }
      other.angles = clamp_to_range(other.angles);
      other.cost = misses(other.angles).squaredNorm();
      const bool better = other.cost < best.cost;
      if (better) best = other;
      damping *= better ? .3 : 4;
    }
    return best;
  }

  // Angles that the descent would push out of their range do not take part in it.
  void hold_at_limits(const JointAngles& angles, const Misses& here, Jacobian& jacobian) const {
    const Eigen::Matrix<double, kMoved, 1> uphill = jacobian.transpose() * here;
    for (int i = 0; i < kMoved; ++i) {
      JointAngles downhill = angles;
      const int angle = angles_[static_cast<std::size_t>(i)];
      downhill[angle] -= std::copysign(1e-6, uphill[i]);
      if (clamp_to_range(downhill)[angle] == angles[angle]) jacobian.col(i).setZero();
    }
  }

  Jacobian jacobian_at(const JointAngles& angles, const Misses& here) const {
    constexpr double kTurn = 1e-6;
    Jacobian jacobian;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
      JointAngles turned = angles;
      turned[angles_[i]] += kTurn;
      jacobian.col(static_cast<Eigen::Index>(i)) = (misses(turned) - here) / kTurn;
    }
    return jacobian;
  }

  const Skeleton& skeleton_;
  DigitPulp thumb_, finger_;
  std::array<int, kMoved> angles_;  // the thumb's, then the finger's
  RandomStream random_{0};
};

}  // namespace

double Meeting::badness() const {
  return std::max(gap / kGapGate, facing / kFacingGate);
}

Meeting best_meeting(const Skeleton& skeleton, const DigitPulp& thumb, const DigitPulp& finger) {
  return MeetingSearch(skeleton, thumb, finger).find();
}

}  // namespace graspdb
