// SPDX-License-Identifier: MIT
#include "hand_check_reach.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "graspdb/named_poses.h"
#include "graspdb/random.h"
#include "hand_check_geometry.h"
#include "hand_check_lines.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

constexpr double kGapGate = .002;  // metres
constexpr double kFacingGate = radians(60);

// The triangles of a digit's distal bone alone, in some pose.
std::vector<Corners> distal_skin(const Hand& hand, const Mesh& posed, int digit) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::vector<Corners> skin;
  for (const Triangle& t : posed.triangles) {
    const auto is_distal = [&](std::uint32_t v) { return bones[v] == distal_bone(digit); };
    if (std::all_of(t.begin(), t.end(), is_distal)) skin.push_back(corners_of(posed, t));
  }
  return skin;
}

// A point of the skin in the frame of the digit's distal bone; it looks palmar.
std::optional<Vector3d> pulp_in_distal(const Hand& hand, int digit) {
  const auto d = static_cast<std::size_t>(digit);
  const RigidTransform& palm_from_bone = hand.palm_from_bone_at_bind[distal_bone(digit)];
  const Vector3d inside = .65 * hand.skeleton.tip_in_distal[d];
  const auto depth = distance_along(palm_from_bone * inside, -palm_from_bone.rotation.col(2),
                                    distal_skin(hand, hand.bind_mesh, digit));
  if (!depth) return std::nullopt;
  return Vector3d(inside - *depth * Vector3d::UnitZ());
}

struct Pulp {
  Vector3d place, palmar;  // hand frame
};

// The angles of the thumb, or of a finger.
struct Digit {
  int number;          // thumb 0 to little finger 4
  Vector3d in_distal;  // its pulp

  int first_angle() const {
    return number == 0 ? static_cast<int>(kThumbCmcFlexion) : finger_angle(number - 1, kCmcFlexion);
  }
  int end_angle() const {
    return number == 0 ? static_cast<int>(kFirstFingerAngle) : first_angle() + 5;
  }

  Pulp pulp(const PerBone<RigidTransform>& palm_from_bone) const {
    const RigidTransform& frame = palm_from_bone[distal_bone(number)];
    return {frame * in_distal, -frame.rotation.col(2)};
  }
};

struct Meeting {
  JointAngles angles;
  double gap = 1, facing = kPi;  // metres, radians

  double badness() const { return std::max(gap / kGapGate, facing / kFacingGate); }
};

Meeting meeting_of(const JointAngles& angles, const Pulp& thumb, const Pulp& finger) {
  return {angles, (thumb.place - finger.place).norm(),
          std::acos(std::clamp(-thumb.palmar.dot(finger.palmar), -1.0, 1.0))};
}

// Finds where thumb and finger meet best. The two chains are sampled apart and paired, because a
// descent from one start is caught by the facing; then the best pair is walked downhill.
class MeetingSearch {
 public:
  MeetingSearch(const Skeleton& skeleton, const Digit& thumb, const Digit& finger)
      : skeleton_(skeleton), thumb_(thumb), finger_(finger) {}

  Meeting find() {
    Meeting best = best_pair();
    double step = radians(10);
    for (int i = 0; i < kSteps; ++i, step *= kShrinking) {
      JointAngles angles = best.angles;
      for (const Digit* digit : {&thumb_, &finger_}) {
        for (int a = digit->first_angle(); a < digit->end_angle(); ++a) {
          angles[a] += step * random_.normal();
        }
      }
      const Meeting other = evaluated(clamp_to_range(angles));
      if (other.badness() < best.badness()) best = other;
    }
    return best;
  }

 private:
  static constexpr int kSamples = 2000, kSteps = 3000;
  static constexpr double kShrinking = .9975;

  Meeting evaluated(const JointAngles& angles) const {
    const PerBone<RigidTransform> frames = palm_from_bones(skeleton_, angles);
    return meeting_of(angles, thumb_.pulp(frames), finger_.pulp(frames));
  }

  JointAngles drawn(const Digit& digit) {
    JointAngles angles = JointAngles::Zero();
    for (int a = digit.first_angle(); a < digit.end_angle(); ++a) {
      angles[a] = random_.uniform(angle_info(a).lower, angle_info(a).upper);
    }
    return clamp_to_range(angles);
  }

  Meeting best_pair() {
    std::vector<JointAngles> thumb_angles;
    std::vector<Pulp> thumb_pulps;
    for (int i = 0; i < kSamples; ++i) {
      thumb_angles.push_back(drawn(thumb_));
      thumb_pulps.push_back(thumb_.pulp(palm_from_bones(skeleton_, thumb_angles.back())));
    }
    Meeting best;
    for (int i = 0; i < kSamples; ++i) {
      const JointAngles angles = drawn(finger_);
      const Pulp pulp = finger_.pulp(palm_from_bones(skeleton_, angles));
      for (std::size_t t = 0; t < thumb_pulps.size(); ++t) {
        if ((thumb_pulps[t].place - pulp.place).norm() > kGapGate * best.badness()) continue;
        const Meeting other = meeting_of(thumb_angles[t] + angles, thumb_pulps[t], pulp);
        if (other.badness() < best.badness()) best = other;
      }
    }
    return best;
  }

  const Skeleton& skeleton_;
  Digit thumb_, finger_;
  RandomStream random_{0};
};

void add_pulp_lines(const Hand& hand, int finger, std::vector<HandCheckLine>& lines) {
  const std::string gap = fmt::format("pulp gap, {}", finger_name(finger));
  const std::string facing = fmt::format("pulp facing, {}", finger_name(finger));
  const Gate gap_gate = at_most(1000 * kGapGate), facing_gate = at_most(degrees(kFacingGate));
  for (const int digit : {0, finger + 1}) {
    if (moves_skin(hand, distal_bone(digit))) continue;
    const std::string why = no_skin_on(distal_bone(digit));
    lines.push_back(not_applicable(gap, "mm", gap_gate, why));
    lines.push_back(not_applicable(facing, "deg", facing_gate, why));
    return;
  }
  const auto thumb = pulp_in_distal(hand, 0), other = pulp_in_distal(hand, finger + 1);
  if (!thumb || !other) {
    const std::string why = "no skin is palmar of the distal bone";
    lines.push_back(judged(gap, std::nan(""), "mm", gap_gate, why));
    lines.push_back(judged(facing, std::nan(""), "deg", facing_gate, why));
    return;
  }
  const Meeting best = MeetingSearch(hand.skeleton, {0, *thumb}, {finger + 1, *other}).find();
  lines.push_back(judged(gap, 1000 * best.gap, "mm", gap_gate));
  lines.push_back(judged(facing, degrees(best.facing), "deg", facing_gate));
}

// In the fist: the skin that the fingertips should reach.
std::vector<Corners> palm_skin(const Hand& hand, const Mesh& fist) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const auto is_palm = [&](std::uint32_t v) {
    const int bone = bones[v];
    return bone == kPalm || bone == kThumbMetacarpal ||
           (bone >= kFirstFingerBone && (bone - kFirstFingerBone) % 4 == kMetacarpal);
  };
  std::vector<Corners> skin;
  for (const Triangle& t : fist.triangles) {
    if (std::all_of(t.begin(), t.end(), is_palm)) skin.push_back(corners_of(fist, t));
  }
  return skin;
}

HandCheckLine tip_to_palm(const Hand& hand, const PerBone<RigidTransform>& frames, const Mesh& fist,
                          const std::vector<Corners>& palm, int finger) {
  const std::string name = fmt::format("tip to palm, {}", finger_name(finger));
  const Bone bone = finger_bone(finger, kDistal);
  if (!moves_skin(hand, bone)) {
    return not_applicable(name, "mm", at_most(3), no_skin_on(bone));
  }
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const RigidTransform bone_from_palm = frames[bone].inverse();
  const double half = hand.skeleton.tip_in_distal[static_cast<std::size_t>(finger) + 1].y() / 2;
  double least = 1;
  for (std::size_t v = 0; v < fist.vertices.size(); ++v) {
    const Vector3d point = fist.vertices[v].cast<double>();
    if (bones[v] != bone || (bone_from_palm * point).y() < half) continue;
    for (const Corners& t : palm) least = std::min(least, distance_to_triangle(point, t));
  }
  return judged(name, 1000 * least, "mm", at_most(3));
}

}  // namespace

std::vector<HandCheckLine> check_reach(const Hand& hand) {
  std::vector<HandCheckLine> lines;
  for (int finger = 0; finger < kFingerCount; ++finger) add_pulp_lines(hand, finger, lines);
  const PerBone<RigidTransform> frames = palm_from_bones(hand.skeleton, named_pose("fist"));
  const Mesh fist = pose_skin(hand, frames);
  const std::vector<Corners> palm = palm_skin(hand, fist);
  for (int finger = 0; finger < kFingerCount; ++finger) {
    lines.push_back(tip_to_palm(hand, frames, fist, palm, finger));
  }
  return lines;
}

}  // namespace graspdb
