// SPDX-License-Identifier: MIT
#include "pose_measures.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "crossing.h"
#include "graspdb/geometry/inside.h"
#include "skin_samples.h"

namespace graspdb {
namespace {

constexpr double kSampleSpacing = 0.002;  // metres, on the object
constexpr double kReach = 0.05;           // metres: nothing of a hand is thicker than twice this

// A posed hand beside the object, in the hand frame.
struct Scenery {
  Mesh skin;
  std::vector<double> to_object;  // from each vertex, metres
};

Scenery pose_scenery(const Grasp& grasp, const Hand& hand, const GraspPose& pose) {
  Scenery scenery{pose_skin(hand, pose.angles), {}};
  const RigidTransform object_from_hand = pose.hand_from_object.inverse();
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

std::array<double, kPalmAndDigitCount> gaps_mm(const Scenery& scenery,
                                               const std::vector<int>& digit) {
  std::array<double, kPalmAndDigitCount> gaps;
  gaps.fill(std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < digit.size(); ++v) {
    if (digit[v] < 0) continue;
    double& gap = gaps[static_cast<std::size_t>(digit[v])];
    gap = std::min(gap, scenery.to_object[v] * kMillimetersPerMeter);
  }
  return gaps;
}

// Angles as good as at an end of their range, but for those that hardly move at all.
std::vector<std::string> angles_at_limits(const JointAngles& angles) {
  constexpr double kNear = radians(0.5), kSmallRange = radians(5);
  std::vector<std::string> names;
  for (int i = 0; i < kAngleCount; ++i) {
    if (angle_info(i).upper - angle_info(i).lower < kSmallRange) continue;
    for (const double beyond : {-kNear, kNear}) {
      JointAngles moved = angles;
      moved[i] += beyond;
      if (clamp_to_range(moved)[i] == moved[i]) continue;
      names.emplace_back(angle_info(i).name);
      break;
    }
  }
  return names;
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

}  // namespace

PoseMeasures::PoseMeasures(const Hand& hand) : hand_(hand), bones_(strongest_bones(hand)) {
  for (const std::uint8_t bone : bones_) digit_.push_back(digit_of_bone(bone));
  for (int d = 0; d < kDigitCount; ++d)
    tubes_[static_cast<std::size_t>(d)] = phalanges(with_palm(d));
}

PoseMeasures::Tube PoseMeasures::phalanges(int digit) const {
  Tube tube;
  const auto belongs = [&](std::uint32_t v) { return is_phalanx(bones_[v]) && digit_[v] == digit; };
  for (std::uint32_t v = 0; v < bones_.size(); ++v) {
    if (belongs(v)) tube.vertices.push_back(v);
  }
  for (const Triangle& t : hand_.bind_mesh.triangles) {
    if (std::all_of(t.begin(), t.end(), belongs)) tube.triangles.push_back(t);
  }
  return tube;
}

// Skin is behind the tube's nearest vertex when it may be inside: a quick sieve.
bool PoseMeasures::behind_nearest(const Mesh& skin, const Tube& tube,
                                  const Eigen::Vector3f& point) {
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

double PoseMeasures::overlap(const Mesh& skin, const Tube& digit, const Tube& other) {
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

double PoseMeasures::deepest_overlap(const Mesh& skin) const {
  double deepest = 0;
  for (const Tube& digit : tubes_) {
    for (const Tube& other : tubes_) {
      if (&digit != &other) deepest = std::max(deepest, overlap(skin, digit, other));
    }
  }
  return deepest;
}

std::vector<std::string> PoseMeasures::touching_bones(const std::vector<double>& to_object) const {
  std::set<std::uint8_t> touching;
  for (std::size_t v = 0; v < bones_.size(); ++v) {
    if (to_object[v] * kMillimetersPerMeter <= kContactMm) touching.insert(bones_[v]);
  }
  std::vector<std::string> names;
  names.reserve(touching.size());
  for (const std::uint8_t bone : touching) names.emplace_back(bone_name(bone));
  return names;
}

PoseMeasures::Measured PoseMeasures::measure(const Grasp& grasp, const GraspPose& pose) const {
  const Scenery scenery = pose_scenery(grasp, hand_, pose);
  const InsideTest in_hand(scenery.skin);
  const double skin_depth = hand_in_object(scenery);
  const double object_depth = object_in_hand(grasp, scenery, in_hand, pose);
  const double penetration = std::max({0.0, skin_depth, object_depth});
  Measured measured;
  StepCheck& step = measured.step;
  step.penetration_mm = penetration * kMillimetersPerMeter;
  if (penetration > 0) {
    step.volume_cm3 = shared_volume(grasp, scenery, in_hand, pose, penetration) * 1e6;
  }
  step.self_penetration_mm = deepest_overlap(scenery.skin) * kMillimetersPerMeter;
  step.clearance_mm = std::max(0.0, -skin_depth) * kMillimetersPerMeter;
  step.contacts = touching_bones(scenery.to_object);
  step.at_limits = angles_at_limits(pose.angles);
  measured.crossed = crossed_skin(grasp, hand_, pose, scenery.skin, digit_);
  measured.gap_mm = gaps_mm(scenery, digit_);
  return measured;
}

}  // namespace graspdb
