// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "graspdb/closing.h"
#include "graspdb/error.h"
#include "overlap.h"
#include "skin_samples.h"

namespace graspdb {
namespace {

constexpr double kGateMm = 2;
constexpr double kMillimetre = 1000;
constexpr double kSampleSpacing = 0.002;  // metres, on the object
constexpr double kRangeSlack = 1e-6;      // radians: closed poses are written to 1e-6 degrees
constexpr double kReach = 0.05;           // metres: nothing of a hand is thicker than twice this

// A posed hand beside the object, in the hand frame.
struct Scenery {
  Mesh skin;
  std::vector<int> digit;         // of each vertex; -1 forearm
  std::vector<double> to_object;  // from each vertex, metres
};

Scenery pose_scenery(const Grasp& grasp, const Hand& hand, const GraspPose& pose) {
  Scenery scenery{pose_skin(hand, pose.angles), {}, {}};
  const RigidTransform object_from_hand = pose.hand_from_object.inverse();
  for (const std::uint8_t bone : strongest_bones(hand)) {
    scenery.digit.push_back(digit_of_bone(bone));
  }
  for (const Eigen::Vector3f& v : scenery.skin.vertices) {
    scenery.to_object.push_back(grasp.object->distance(object_from_hand * v.cast<double>()));
  }
  return scenery;
}

double object_in_hand(const Grasp& grasp, const Scenery& scenery, const GraspPose& pose) {
  const InsideTest inside(scenery.skin);
  double deepest = 0;
  for (const Eigen::Vector3d& p : surface_points(grasp.object->mesh(), kSampleSpacing)) {
    const Eigen::Vector3d in_hand = pose.hand_from_object * p;
    if (inside.depth_along_z(in_hand) <= deepest) continue;
    deepest = std::max(deepest, distance_to_triangles(scenery.skin, scenery.skin.triangles, in_hand,
                                                      kReach, deepest));
  }
  return deepest;
}

double penetration(const Grasp& grasp, const Scenery& scenery, const GraspPose& pose) {
  const double hand_in_object =
      -*std::min_element(scenery.to_object.begin(), scenery.to_object.end());
  return std::max({0.0, hand_in_object, object_in_hand(grasp, scenery, pose)});
}

bool is_phalanx(int bone) {
  return digit_of_bone(bone) > 0 && bone != kThumbMetacarpal;
}

// The skin of the phalanges of one digit: a tube that is open at the palm.
struct Tube {
  std::vector<std::uint32_t> vertices;
  std::vector<Triangle> triangles;
};

Tube phalanges(const Hand& hand, int digit) {
  Tube tube;
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const auto belongs = [&](std::uint32_t v) {
    return is_phalanx(bones[v]) && digit_of_bone(bones[v]) == digit;
  };
  for (std::uint32_t v = 0; v < bones.size(); ++v) {
    if (belongs(v)) tube.vertices.push_back(v);
  }
  for (const Triangle& t : hand.bind_mesh.triangles) {
    if (std::all_of(t.begin(), t.end(), belongs)) tube.triangles.push_back(t);
  }
  return tube;
}

struct Bounds {
  Eigen::Vector3f low, high;
  bool contain(const Eigen::Vector3f& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
};

Bounds bounds(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
  const float infinity = std::numeric_limits<float>::infinity();
  Bounds box{Eigen::Vector3f::Constant(infinity), Eigen::Vector3f::Constant(-infinity)};
  for (const std::uint32_t v : vertices) {
    box.low = box.low.cwiseMin(mesh.vertices[v]);
    box.high = box.high.cwiseMax(mesh.vertices[v]);
  }
  return box;
}

// Skin is behind the tube's nearest vertex when it may be inside: a quick sieve.
bool behind_nearest(const Mesh& skin, const Tube& tube, const Eigen::Vector3f& point) {
  constexpr float kDoubt = 0.001F;
  float nearest = std::numeric_limits<float>::max();
  float height = 0;
  for (const std::uint32_t v : tube.vertices) {
    const Eigen::Vector3f away = point - skin.vertices[v];
    if (away.squaredNorm() >= nearest) continue;
    nearest = away.squaredNorm();
    height = away.dot(skin.normals[v]);
  }
  return height < kDoubt;
}

double overlap(const Mesh& skin, const Tube& digit, const Tube& other) {
  const Bounds box = bounds(skin, other.vertices);
  double deepest = 0;
  for (const std::uint32_t v : digit.vertices) {
    const Eigen::Vector3f& point = skin.vertices[v];
    if (!box.contain(point) || !behind_nearest(skin, other, point)) continue;
    const Eigen::Vector3d p = point.cast<double>();
    if (winding_number(skin, other.triangles, p) < 0.5) continue;
    deepest = std::max(deepest, distance_to_triangles(skin, other.triangles, p, kReach, deepest));
  }
  return deepest;
}

double deepest_overlap(const Mesh& skin, const std::vector<Tube>& digits) {
  double deepest = 0;
  for (std::size_t a = 0; a < digits.size(); ++a) {
    for (std::size_t b = 0; b < digits.size(); ++b) {
      if (a != b) deepest = std::max(deepest, overlap(skin, digits[a], digits[b]));
    }
  }
  return deepest;
}

std::vector<std::string> touching_bones(const Hand& hand, const Scenery& scenery) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::set<std::uint8_t> touching;
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (scenery.to_object[v] * kMillimetre <= kGateMm) touching.insert(bones[v]);
  }
  std::vector<std::string> names;
  for (const std::uint8_t bone : touching) names.emplace_back(bone_name(bone));
  return names;
}

double gap_mm(const Scenery& scenery, int digit) {
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < scenery.digit.size(); ++v) {
    if (scenery.digit[v] == digit) gap = std::min(gap, scenery.to_object[v] * kMillimetre);
  }
  return gap;
}

void check_contacts(const Grasp& grasp, const Scenery& closed, GraspCheck& check) {
  const auto name = [](int digit) { return kDigitNames[static_cast<std::size_t>(digit)]; };
  for (const int digit : grasp.required_digits) {
    const double gap = gap_mm(closed, digit);
    if (gap <= kGateMm) continue;
    check.failures.push_back(fmt::format(
        "{} must touch but is {:.1f} mm from the object (gate {} mm)", name(digit), gap, kGateMm));
  }
  for (const int digit : grasp.free_digits) {
    const double gap = gap_mm(closed, digit);
    if (gap > kGateMm) continue;
    check.failures.push_back(
        fmt::format("{} must stay free but is {:.1f} mm from the object (gate {} mm)", name(digit),
                    gap, kGateMm));
  }
}

void check_ranges(const JointAngles& angles, GraspCheck& check) {
  const JointAngles clamped = clamp_to_range(angles);
  for (int i = 0; i < kAngleCount; ++i) {
    if (std::abs(angles[i] - clamped[i]) <= kRangeSlack) continue;
    check.failures.push_back(fmt::format("{} is {:.1f} degrees, beyond its limit of {:.1f}",
                                         angle_info(i).name, degrees(angles[i]),
                                         degrees(clamped[i])));
  }
}

void check_step(const StepCheck& step, GraspCheck& check) {
  if (step.penetration_mm > kGateMm) {
    check.failures.push_back(
        fmt::format("step {}: hand and object overlap by {:.1f} mm (gate {} mm)", step.step,
                    step.penetration_mm, kGateMm));
  }
  if (step.self_penetration_mm > kGateMm) {
    check.failures.push_back(fmt::format("step {}: digits overlap by {:.1f} mm (gate {} mm)",
                                         step.step, step.self_penetration_mm, kGateMm));
  }
}

}  // namespace

GraspCheck check_grasp(const Grasp& grasp, const Hand& hand, const JointAngles& rest,
                       const GraspPose& closed) {
  std::vector<Tube> digits;
  for (int digit = 1; digit < kDigitCount; ++digit) digits.push_back(phalanges(hand, digit));
  GraspCheck check;
  for (int number = 1; number <= kStepCount; ++number) {
    const GraspPose pose = pose_at_step(grasp, rest, closed, number);
    const Scenery scenery = pose_scenery(grasp, hand, pose);
    const double nearest = *std::min_element(scenery.to_object.begin(), scenery.to_object.end());
    check.steps.push_back({number, penetration(grasp, scenery, pose) * kMillimetre,
                           deepest_overlap(scenery.skin, digits) * kMillimetre,
                           std::max(0.0, nearest) * kMillimetre, touching_bones(hand, scenery)});
    check_step(check.steps.back(), check);
    if (number == kStepCount) check_contacts(grasp, scenery, check);
  }
  check_ranges(closed.angles, check);
  check.pass = check.failures.empty();
  return check;
}

}  // namespace graspdb
