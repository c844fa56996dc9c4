// SPDX-License-Identifier: MIT
#include "jitter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "graspdb/core/hash.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// The angle nearest to `value` that the others allow.
double reachable(JointAngles angles, int angle, double value) {
  angles[angle] = value;
  return clamp_to_range(angles)[angle];
}

}  // namespace

nlohmann::json jitter_json(const Jitter& jitter) {
  return {{"angles_deg", jitter.angles_deg},
          {"wrist_deg", jitter.wrist_deg},
          {"object_size_percent", jitter.object_size_percent},
          {"visible_forearm_mm", jitter.visible_forearm_mm},
          {"light_deg", jitter.light_deg},
          {"seed", jitter.seed},
          {"copies", jitter.copies}};
}

JitterDraw::JitterDraw(const Jitter& jitter, const std::string& hand, int grasp, int copy)
    : jitter_(jitter), key_(fmt::format("{} grasp {} copy {}", hand, grasp, copy)) {}

RandomStream JitterDraw::stream(const std::string& purpose) const {
  const std::string digits = hash_hex(key_ + " " + purpose).substr(0, 16);
  return RandomStream(static_cast<std::uint64_t>(jitter_.seed), std::stoull(digits, nullptr, 16));
}

JointAngles JitterDraw::angles(const JointAngles& stated) const {
  JointAngles angles = stated;
  RandomStream random = stream("angles");
  // A finger's flexion stands before its abduction, whose range depends on it.
  for (int i = 0; i < kAngleCount; ++i) {
    const double share = random.uniform();
    const double amplitude = radians(i <= kWristDeviation ? jitter_.wrist_deg : jitter_.angles_deg);
    if (amplitude == 0) continue;
    const double low = reachable(angles, i, stated[i] - amplitude);
    const double high = reachable(angles, i, stated[i] + amplitude);
    angles[i] = low + share * (high - low);
  }
  return angles;
}

double JitterDraw::object_scale() const {
  const double amplitude = jitter_.object_size_percent / 100;
  return 1 + stream("object size").uniform(-amplitude, amplitude);
}

double JitterDraw::visible_forearm(double stated) const {
  const double amplitude = jitter_.visible_forearm_mm / 1000;
  return stream("forearm").uniform(std::max(stated - amplitude, 0.0), stated + amplitude);
}

Light JitterDraw::light(const Light& stated, std::size_t view) const {
  if (jitter_.light_deg == 0) return stated;
  RandomStream random = stream(fmt::format("light {}", view));
  const Eigen::Vector3d& towards = stated.towards_light_in_camera;
  const double cosine = random.uniform(std::cos(radians(jitter_.light_deg)), 1);
  const double azimuth = random.uniform(0, 2 * kPi), radius = std::sqrt(1 - cosine * cosine);
  const Eigen::Vector3d in_cone(radius * std::cos(azimuth), radius * std::sin(azimuth), cosine);
  const auto turn = rotation_between(Eigen::Vector3d::UnitZ(), towards);
  Light light = stated;
  light.towards_light_in_camera = towards.norm() * (turn * in_cone);
  return light;
}

}  // namespace graspdb
