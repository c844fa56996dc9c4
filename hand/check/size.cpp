// SPDX-License-Identifier: MIT
#include "size.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "graspdb/hand/named_poses.h"
#include "lines.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = .01;  // share of what was asked

double skin_length_mm(const Hand& hand, const Mesh& flat) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  double length = 0;
  for (std::size_t v = 0; v < flat.vertices.size(); ++v) {
    if (bones[v] != finger_bone(1, kDistal)) continue;
    length = std::max<double>(length, flat.vertices[v].y());
  }
  return 1000 * length;
}

// Where the skin's edges cross the plane through the two outer knuckles.
double skin_breadth_mm(const Hand& hand, const Mesh& flat) {
  const auto& zero = hand.skeleton.hand_from_bone_at_zero;
  const Vector3d index = zero[finger_bone(0, kProximal)].translation;
  const Vector3d little = zero[finger_bone(3, kProximal)].translation;
  const Vector3d across = (little - index).normalized();
  const Vector3d along = Vector3d::UnitZ().cross(across).normalized();
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const auto counts = [&](std::uint32_t v) {
    return bones[v] == kPalm || bones[v] >= kFirstFingerBone;
  };
  double low = 0, high = 0;
  for (const Triangle& t : flat.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      const Vector3d a = flat.vertices[from].cast<double>() - index;
      const Vector3d b = flat.vertices[to].cast<double>() - index;
      if (!counts(from) || !counts(to) || a.dot(along) * b.dot(along) >= 0) continue;
      const double part = a.dot(along) / (a - b).dot(along);
      const double place = (a + part * (b - a)).dot(across);
      low = std::min(low, place);
      high = std::max(high, place);
    }
  }
  return 1000 * (high - low);
}

HandCheckLine size_line(const std::string& name, double measured_mm,
                        const std::optional<double>& asked_mm) {
  if (!asked_mm) {
    return {name,
            measured_mm,
            "mm",
            "",
            HandCheckLine::Status::kNotApplicable,
            "not known what was asked for"};
  }
  return judged(name, measured_mm, "mm",
                between((1 - kTolerance) * *asked_mm, (1 + kTolerance) * *asked_mm));
}

}  // namespace

std::vector<HandCheckLine> check_size(const Hand& hand, const std::optional<AskedSize>& asked) {
  const Mesh flat = pose_skin(hand, named_pose("flat"));
  const auto asked_for = [&](double AskedSize::*measure) {
    return asked ? std::optional(*asked.*measure) : std::nullopt;
  };
  HandCheckLine length =
      size_line("hand length", skin_length_mm(hand, flat), asked_for(&AskedSize::length_mm));
  if (!moves_skin(hand, finger_bone(1, kDistal))) {
    length = not_applicable("hand length", "mm", {}, no_skin_on(finger_bone(1, kDistal)));
  }
  return {length, size_line("hand breadth", skin_breadth_mm(hand, flat),
                            asked_for(&AskedSize::breadth_mm))};
}

}  // namespace graspdb
