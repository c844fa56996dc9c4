// SPDX-License-Identifier: MIT
#include "hand_check_poses.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "graspdb/named_poses.h"
#include "hand_check_geometry.h"
#include "hand_check_lines.h"
#include "hand_check_surface.h"

namespace graspdb {
namespace {

// One angle at one end of its range.
struct Limit {
  int angle;
  double value;  // radians

  JointAngles angles() const {
    JointAngles angles = JointAngles::Zero();
    angles[angle] = value;
    return angles;
  }
  std::string text() const {
    return fmt::format("{} {:.0f} deg", angle_info(angle).name, degrees(value));
  }
};

std::vector<Limit> limits_of(const AngleGroup& group) {
  std::vector<Limit> limits;
  for (int angle = group.first; angle < group.end; ++angle) {
    limits.push_back({angle, angle_info(angle).lower});
    limits.push_back({angle, angle_info(angle).upper});
  }
  return limits;
}

// How each vertex' surroundings are turned from the bind pose: the blend of its bones' rotations.
std::vector<Eigen::Matrix3f> turns_of_vertices(const Hand& hand,
                                               const PerBone<RigidTransform>& palm_from_bone) {
  PerBone<Eigen::Matrix3f> turns;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    turns[bone] =
        (palm_from_bone[bone].rotation * hand.palm_from_bone_at_bind[bone].rotation.transpose())
            .cast<float>();
  }
  std::vector<Eigen::Matrix3f> blends(hand.weights.size(), Eigen::Matrix3f::Zero());
  for (std::size_t v = 0; v < blends.size(); ++v) {
    const SkinWeights& skin = hand.weights[v];
    for (std::size_t i = 0; i < 4; ++i) {
      if (skin.weight[i] > 0) blends[v] += skin.weight[i] * turns[skin.bone[i]];
    }
  }
  return blends;
}

std::size_t count_inverted(const Hand& hand, const JointAngles& angles) {
  const PerBone<RigidTransform> frames = palm_from_bones(hand.skeleton, angles);
  const Mesh posed = pose_skin(hand, frames);
  const std::vector<Eigen::Matrix3f> turns = turns_of_vertices(hand, frames);
  std::size_t inverted = 0;
  for (const Triangle& t : posed.triangles) {
    const Eigen::Matrix3f turn = turns[t[0]] + turns[t[1]] + turns[t[2]];
    const Eigen::Vector3d expected = turn.cast<double>() * corners_of(hand.bind_mesh, t).normal();
    inverted += corners_of(posed, t).normal().dot(expected) < 0;
  }
  return inverted;
}

double inverted_percent(const Hand& hand, const JointAngles& angles) {
  return 100 * static_cast<double>(count_inverted(hand, angles)) /
         static_cast<double>(hand.bind_mesh.triangles.size());
}

HandCheckLine worst_inverted(const Hand& hand, const AngleGroup& group) {
  Worst worst;
  for (const Limit& limit : limits_of(group)) {
    worst.take(inverted_percent(hand, limit.angles()), [&] { return limit.text(); });
  }
  Missing missing;
  if (group.first == kWristFlexion) missing.lacks_skin(hand, kForearm);
  return judged_unless(missing, fmt::format("inverted triangles, limits of {}", group.name), worst,
                       "%", at_most(.5));
}

void add_inverted_lines(const Hand& hand, std::vector<HandCheckLine>& lines) {
  for (const char* pose : {"flat", "wrap", "pinch"}) {
    lines.push_back(judged(fmt::format("inverted triangles, {}", pose),
                           static_cast<double>(count_inverted(hand, named_pose(pose))), "",
                           at_most(2)));
  }
  lines.push_back(judged("inverted triangles, fist", inverted_percent(hand, named_pose("fist")),
                         "%", at_most(.5)));
  for (const AngleGroup& group : kAngleGroups) lines.push_back(worst_inverted(hand, group));
}

// In percent of the bind pose's volume.
double volume_change(const Hand& hand, const JointAngles& angles) {
  return 100 * (volume_of(pose_skin(hand, angles)) / volume_of(hand.bind_mesh) - 1);
}

HandCheckLine worst_thumb_volume(const Hand& hand) {
  Worst worst;
  double change = 0;
  for (const Limit& limit : limits_of(kAngleGroups[1])) {
    const double here = volume_change(hand, limit.angles());
    worst.take(std::abs(here), [&] {
      change = here;
      return limit.text();
    });
  }
  return judged("volume change, limits of thumb", change, "%", between(-3, 3), worst.where);
}

void add_volume_lines(const Hand& hand, std::vector<HandCheckLine>& lines) {
  constexpr std::array<const char*, 4> kPoses = {"flat", "wrap", "pinch", "fist"};
  const bool closed = is_closed(hand.bind_mesh);
  for (const std::string_view pose : kPoses) {
    const std::string name = fmt::format("volume change, {}", pose);
    const Gate gate = between(pose == "fist" ? -6 : -3, 3);
    lines.push_back(closed ? judged(name, volume_change(hand, named_pose(pose)), "%", gate)
                           : not_applicable(name, "%", gate, "the surface is open"));
  }
  lines.push_back(closed ? worst_thumb_volume(hand)
                         : not_applicable("volume change, limits of thumb", "%", between(-3, 3),
                                          "the surface is open"));
}

// How far the skin of the finger's first two phalanges lies dorsally of the PIP joint.
std::optional<double> pip_back(const Hand& hand, int finger, double flexion) {
  JointAngles angles = JointAngles::Zero();
  angles[finger_angle(finger, kPipFlexion)] = flexion;
  const PerBone<RigidTransform> frames = palm_from_bones(hand.skeleton, angles);
  const Mesh posed = pose_skin(hand, frames);
  const Bone before = finger_bone(finger, kProximal), after = finger_bone(finger, kMiddle);
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::vector<Corners> skin;
  for (const Triangle& t : posed.triangles) {
    const auto is_near = [&](std::uint32_t v) { return bones[v] == before || bones[v] == after; };
    if (is_near(t[0]) && is_near(t[1]) && is_near(t[2])) skin.push_back(corners_of(posed, t));
  }
  const Eigen::Vector3d back = frames[before].rotation.col(2) + frames[after].rotation.col(2);
  return distance_along(frames[after].translation, back.normalized(), skin);
}

HandCheckLine pip_section(const Hand& hand, int finger) {
  const std::string name = fmt::format("PIP section, {}", finger_name(finger));
  for (const FingerBone part : {kProximal, kMiddle}) {
    const Bone bone = finger_bone(finger, part);
    if (!moves_skin(hand, bone)) return not_applicable(name, "%", at_least(85), no_skin_on(bone));
  }
  const auto straight = pip_back(hand, finger, 0), bent = pip_back(hand, finger, radians(105));
  if (!straight || !bent) {
    return judged(name, std::nan(""), "%", at_least(85), "the joint does not lie in its skin");
  }
  return judged(name, 100 * *bent / *straight, "%", at_least(85),
                fmt::format("{:.1f} of {:.1f} mm", 1000 * *bent, 1000 * *straight));
}

}  // namespace

std::vector<HandCheckLine> check_poses(const Hand& hand) {
  std::vector<HandCheckLine> lines;
  add_inverted_lines(hand, lines);
  add_volume_lines(hand, lines);
  for (int finger = 0; finger < kFingerCount; ++finger) lines.push_back(pip_section(hand, finger));
  return lines;
}

}  // namespace graspdb
