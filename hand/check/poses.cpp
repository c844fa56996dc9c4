// SPDX-License-Identifier: MIT
#include "poses.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "graspdb/geometry/topology.h"
#include "graspdb/geometry/triangle.h"
#include "graspdb/hand/named_poses.h"
#include "lines.h"

namespace graspdb {
namespace {

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
  const bool closed = is_closed(hand.bind_mesh.triangles);
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
  const PerBone<RigidTransform> frames = hand_from_bones(hand.skeleton, angles);
  const Mesh posed = pose_skin(hand, frames);
  const int before = finger_bone(finger, kProximal), after = finger_bone(finger, kMiddle);
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
    const int bone = finger_bone(finger, part);
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
  add_volume_lines(hand, lines);
  for (int finger = 0; finger < kFingerCount; ++finger) lines.push_back(pip_section(hand, finger));
  return lines;
}

}  // namespace graspdb
