// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
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

double object_in_hand(const Grasp& grasp, const Scenery& scenery, const InsideTest& in_hand,
                      const GraspPose& pose) {
  double deepest = 0;
  for (const Eigen::Vector3d& on_object : surface_points(grasp.object->mesh(), kSampleSpacing)) {
    const Eigen::Vector3d p = pose.hand_from_object * on_object;
    if (in_hand.depth_along_z(p) <= deepest) continue;
    deepest = std::max(
        deepest, distance_to_triangles(scenery.skin, scenery.skin.triangles, p, kReach, deepest));
  }
  return deepest;
}

double hand_in_object(const Scenery& scenery) {
  return -*std::min_element(scenery.to_object.begin(), scenery.to_object.end());
}

// What hand and object have in common, cubic metres, by a grid over the skin's box. Skin is nowhere
// deeper in the object than `deepest`.
double shared_volume(const Grasp& grasp, const Scenery& scenery, const InsideTest& in_hand,
                     const GraspPose& pose, double deepest) {
  constexpr double kGrid = 0.00125;  // metres
  const RigidTransform object_from_hand = pose.hand_from_object.inverse();
  std::vector<std::uint32_t> all(scenery.skin.vertices.size());
  std::iota(all.begin(), all.end(), 0U);
  const Bounds box = bounds(scenery.skin, all);
  const Eigen::Vector3d low = box.low.cast<double>();
  const Eigen::Vector3i count = ((box.high - box.low) / kGrid).cast<int>();
  std::size_t shared = 0;
  for (int x = 0; x <= count.x(); ++x) {
    for (int y = 0; y <= count.y(); ++y) {
      for (int z = 0; z <= count.z(); ++z) {
        const Eigen::Vector3d p = low + kGrid * Eigen::Vector3d(x, y, z);
        const double distance = grasp.object->distance(object_from_hand * p);
        if (distance < -deepest - kGrid) continue;
        // Nothing is within the distance: leap.
        if (distance > kGrid) {
          z += static_cast<int>(distance / kGrid) - 1;
        } else if (distance < 0 && in_hand.depth_along_z(p) > 0) {
          ++shared;
        }
      }
    }
  }
  return static_cast<double>(shared) * kGrid * kGrid * kGrid;
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
  names.reserve(touching.size());
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

StepCheck measure(const Grasp& grasp, const Hand& hand, const std::vector<Tube>& digits,
                  const Scenery& scenery, const GraspPose& pose) {
  const InsideTest in_hand(scenery.skin);
  const double skin_depth = hand_in_object(scenery);
  const double object_depth = object_in_hand(grasp, scenery, in_hand, pose);
  const double penetration = std::max({0.0, skin_depth, object_depth});
  StepCheck step;
  step.penetration_mm = penetration * kMillimetre;
  if (penetration > 0) {
    step.volume_cm3 = shared_volume(grasp, scenery, in_hand, pose, penetration) * 1e6;
  }
  step.self_penetration_mm = deepest_overlap(scenery.skin, digits) * kMillimetre;
  step.clearance_mm = std::max(0.0, -skin_depth) * kMillimetre;
  step.contacts = touching_bones(hand, scenery);
  return step;
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
    check.steps.push_back(measure(grasp, hand, digits, scenery, pose));
    check.steps.back().step = number;
    check_step(check.steps.back(), check);
    if (number == kStepCount) check_contacts(grasp, scenery, check);
  }
  check_ranges(closed.angles, check);
  check.pass = check.failures.empty();
  return check;
}

}  // namespace graspdb
