// SPDX-License-Identifier: MIT
#include "sample_poses.h"

#include <algorithm>

#include "graspdb/core/transform.h"
#include "graspdb/hand/digits.h"

namespace graspdb {
namespace {

constexpr int kClosures = 20;  // steps from rest to closed

// Half of the poses are anywhere on the way, half near its end, where hands are most of the time.
int draw_closure(RandomStream& random) {
  const bool near_end = random.uniform() < 0.5;
  return near_end ? kClosures - static_cast<int>(random.below(9))
                  : static_cast<int>(random.below(kClosures + 1));
}

GraspPose pose_of(const HandLibrary& library, const BaseHand& base, std::size_t grasp,
                  int closure) {
  return pose_at_step(base.grasps[grasp], library.rest, base.closed[grasp], closure, kClosures);
}

// Angles of a digit: the thumb's six, a finger's five.
std::pair<int, int> angles_of_digit(int digit) {
  if (digit == 0) return {kThumbCmcFlexion, kFirstFingerAngle - kThumbCmcFlexion};
  return {finger_angle(digit - 1, kCmcFlexion), 5};
}

JointAngles mixed(const JointAngles& a, const JointAngles& b, RandomStream& random) {
  if (random.uniform() < 0.5) {
    const double share = random.uniform();
    return (1 - share) * a + share * b;
  }
  JointAngles angles = a;
  for (int digit = 0; digit < kDigitCount; ++digit) {
    if (random.uniform() < 0.5) continue;
    const auto [first, count] = angles_of_digit(digit);
    angles.segment(first, count) = b.segment(first, count);
  }
  return angles;
}

double degrees_between(RandomStream& random, double low, double high) {
  return radians(random.uniform(low, high));
}

// Knuckle and middle joint of a finger: straight, curled, hooked or anything.
std::pair<double, double> draw_curl(RandomStream& random) {
  const double kind = random.uniform();
  const auto draw = [&](double mcp_low, double mcp_high, double pip_low, double pip_high) {
    const double mcp = degrees_between(random, mcp_low, mcp_high);
    return std::pair(mcp, degrees_between(random, pip_low, pip_high));
  };
  if (kind < 0.35) return draw(-15, 25, 0, 20);
  if (kind < 0.65) return draw(50, 95, 70, 110);
  if (kind < 0.80) return draw(-10, 40, 50, 110);
  return draw(-10, 90, 0, 105);
}

// Every finger by itself, but that the little one often goes with the ring finger and that the
// last joint follows the middle one, as tendons have it.
JointAngles gesture(JointAngles angles, RandomStream& random) {
  constexpr double kSpreadDeg[kFingerCount] = {18, 4, -10, -24};
  const double spread = random.uniform(-0.3, 1);
  std::pair<double, double> curl;
  for (int finger = 0; finger < kFingerCount; ++finger) {
    const bool follows = finger == kFingerCount - 1 && random.uniform() < 0.4;
    if (!follows) curl = draw_curl(random);
    angles[finger_angle(finger, kMcpFlexion)] = curl.first;
    angles[finger_angle(finger, kPipFlexion)] = curl.second;
    angles[finger_angle(finger, kDipFlexion)] = curl.second * random.uniform(0.4, 0.8);
    angles[finger_angle(finger, kMcpAbduction)] = radians(kSpreadDeg[finger] * spread);
  }
  angles[kThumbCmcFlexion] = degrees_between(random, -20, 45);
  angles[kThumbCmcAbduction] = degrees_between(random, 0, 60);
  angles[kThumbCmcAxial] = degrees_between(random, -10, 60);
  angles[kThumbMcpFlexion] = degrees_between(random, -5, 55);
  angles[kThumbIpFlexion] = degrees_between(random, -10, 75);
  return angles;
}

// Each angle by itself, and all fingers together.
JointAngles varied(JointAngles angles, const SampleConfig& config, RandomStream& random) {
  const double each = radians(config.angles_deg) * 0.6, together = each * random.normal();
  for (int angle = kThumbCmcFlexion; angle < kAngleCount; ++angle) {
    angles[angle] += each * random.normal();
  }
  for (int finger = 0; finger < kFingerCount; ++finger) {
    angles[finger_angle(finger, kMcpFlexion)] += together;
    angles[finger_angle(finger, kPipFlexion)] += together;
  }
  angles[kWristFlexion] += radians(config.wrist_deg) * random.normal();
  angles[kWristDeviation] += radians(config.wrist_deg) * 0.4 * random.normal();
  return clamp_to_range(angles);
}

JointAngles free_angles(const HandLibrary& library, const BaseHand& base, const JointAngles& grasp,
                        const SampleConfig& config, RandomStream& random) {
  const double kind = random.uniform();
  if (kind < config.gestures) return gesture(grasp, random);
  if (kind >= config.gestures + config.mixtures) return grasp;
  const std::size_t other = random.below(base.grasps.size());
  return mixed(grasp, pose_of(library, base, other, kClosures).angles, random);
}

// Short ones as rows have them, and long ones, or what a sleeve leaves.
double draw_forearm(const SampleConfig& config, RandomStream& random) {
  const double longest = config.forearm_mm / kMillimetersPerMeter;
  return random.uniform(0, random.uniform() < 0.4 ? std::min(0.03, longest) : longest);
}

}  // namespace

SamplePose draw_pose(const HandLibrary& library, const SampleHand& hand, const SampleConfig& config,
                     RandomStream& random) {
  const BaseHand& base = *hand.base;
  const std::size_t grasp = random.below(base.grasps.size());
  const bool held = random.uniform() < config.held;
  SamplePose drawn{.pose = pose_of(library, base, grasp, draw_closure(random)),
                   .object = nullptr,
                   .grasp = held ? base.grasps[grasp].id : 0};
  drawn.pose.hand_from_object.translation *= hand.scale;
  if (held) {
    const double size = config.object_size_percent / 100;
    drawn.object =
        scaled(base.grasps[grasp].object, hand.scale * (1 + random.uniform(-size, size / 3)));
  } else {
    drawn.pose.angles = free_angles(library, base, drawn.pose.angles, config, random);
  }
  drawn.pose.angles = varied(drawn.pose.angles, config, random);
  drawn.visible_forearm = draw_forearm(config, random);
  return drawn;
}

}  // namespace graspdb
