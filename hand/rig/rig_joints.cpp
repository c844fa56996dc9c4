// SPDX-License-Identifier: MIT
#include "rig_joints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>

#include "graspdb/core/error.h"
#include "graspdb/hand/digits.h"
#include "rig_fault.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;

constexpr double kShortestHandM = .10, kLongestHandM = .24;
constexpr double kShortestBoneM = .003;
constexpr double kLongestTipM = .06;
constexpr double kLargestRestBend = radians(150);
// A metacarpal that a rig lacks begins here between wrist and knuckle: .26 to .30 in our hands, .33
// in WebXR's.
constexpr double kCmcShare = .3;

class JointReader {
 public:
  JointReader(const RigMap& map, const RigFile& file)
      : map_(map), file_(file), meters_from_file_(meters_from_file(map)) {}

  RestJoints read() {
    for (int bone = 0; bone < kBoneCount; ++bone) read_bone(bone);
    for (int digit = 0; digit < kDigitCount; ++digit) read_tip(digit);
    joints_.thumb_nail = (meters_from_file_ * map_.thumb_nail).normalized();
    joints_.finger_rolls = map_.finger_rolls;
    correct();
    add_absent();
    check_size();
    for (int digit = 0; digit < kDigitCount; ++digit) check_chain(digit);
    return joints_;
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& expected,
                         const std::string& found) const {
    graspdb::fail(map_, file_, key, expected, found);
  }

  Vector3d joint(const std::string& name, const std::string& key) const {
    const auto found = file_.joints.find(name);
    if (found == file_.joints.end()) {
      std::vector<std::string> names;
      for (const auto& [known, place] : file_.joints) names.push_back(known);
      fail(key, fmt::format("one of {}", fmt::join(names, ", ")), "no \"" + name + "\"");
    }
    if (!found->second.allFinite()) fail(key, "a place", "no number for \"" + name + "\"");
    return meters_from_file_ * found->second;
  }

  void read_bone(int bone) {
    const std::vector<std::string>& names = map_.bones[bone];
    for (const std::string& name : names) joint(name, bone_key(bone));
    if (!names.empty()) joints_.origins[bone] = joint(names.front(), bone_key(bone));
  }

  void read_tip(int digit) {
    const int bone = distal_bone(digit);
    const Vector3d& distal = joints_.origins[bone];
    Vector3d& tip = joints_.tips[digit];
    const TipPlace& place = map_.tips[digit];
    if (const auto* name = std::get_if<std::string>(&place)) {
      tip = joint(*name, tip_key(digit));
    } else if (const auto* point = std::get_if<Vector3d>(&place)) {
      tip = meters_from_file_ * *point;
    } else if (const auto* length = std::get_if<double>(&place)) {
      tip = distal + *length * towards_skin(bone).normalized();
    } else {
      tip = distal + depth_of(bone, towards_skin(bone)) * towards_skin(bone);
    }
  }

  // From a joint to the middle of the skin that moves with it. In our hands that is within 3
  // degrees of the bone's direction, however bent the finger rests.
  Vector3d towards_skin(int bone) const {
    Vector3d sum = Vector3d::Zero();
    double count = 0;
    for (std::size_t v = 0; v < file_.shares.size(); ++v) {
      for (const BoneShare& share : file_.shares[v]) {
        const auto ours = map_.bone_of_name.find(file_.bones[share.bone]);
        if (ours == map_.bone_of_name.end() || ours->second != bone || share.weight < .5) continue;
        sum += meters_from_file_ * file_.mesh.vertices[v].cast<double>();
        ++count;
      }
    }
    const Vector3d& joint = joints_.origins[bone];
    return count > 0 ? Vector3d(sum / count - joint) : Vector3d(joint - joints_.origins[bone - 1]);
  }

  // How many times `onward` it takes from a joint to where that line leaves the flesh.
  double depth_of(int bone, const Vector3d& onward) const {
    const Vector3d& distal = joints_.origins[bone];
    double nearest = kLongestTipM / onward.norm();
    bool found = false;
    for (const Triangle& t : file_.mesh.triangles) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) {
        corners.col(i) = meters_from_file_ * file_.mesh.vertices[t[i]].cast<double>() - distal;
      }
      // onward * distance = corners * shares, and shares that sum to 1 are >= 0 inside.
      const Vector3d shares = corners.partialPivLu().solve(onward);
      if (!shares.allFinite() || shares.minCoeff() < 0) continue;  // not finite: seen edge-on
      const double distance = 1 / shares.sum();
      if (distance > nearest) continue;
      nearest = distance;
      found = true;
    }
    if (!found) {
      fail(bone_key(bone), "skin beyond its joint", fmt::format("none within {} m", kLongestTipM));
    }
    return nearest;
  }

  Vector3d far_end(int bone) const {
    if (bone == kPalm) return joints_.origins[finger_bone(1, kProximal)];
    for (int digit = 0; digit < kDigitCount; ++digit) {
      if (bone == distal_bone(digit)) return joints_.tips[digit];
    }
    return joints_.origins[bone + 1];
  }

  void correct() {
    PerBone<Vector3d> corrected = joints_.origins;
    for (int bone = 0; bone < kBoneCount; ++bone) {
      const double distance = map_.moved_along[bone];
      if (distance == 0) continue;
      const Vector3d& origin = joints_.origins[bone];
      corrected[bone] += distance * (far_end(bone) - origin).normalized();
    }
    joints_.origins = corrected;
  }

  void add_absent() {
    const Vector3d& wrist = joints_.origins[kPalm];
    for (int finger = 0; finger < kFingerCount; ++finger) {
      const Bone metacarpal = finger_bone(finger, kMetacarpal);
      if (!map_.bones[metacarpal].empty()) continue;
      const Vector3d& knuckle = joints_.origins[finger_bone(finger, kProximal)];
      joints_.origins[metacarpal] = wrist + kCmcShare * (knuckle - wrist);
    }
    if (map_.bones[kForearm].empty()) {  // in line with the hand, as far as the palm is long
      joints_.origins[kForearm] = 2 * wrist - joints_.origins[finger_bone(1, kProximal)];
    }
  }

  void check_size() const {
    double length = 0;
    for (const int bone : {int{kPalm}, first_bone(2), first_bone(2) + 1, first_bone(2) + 2}) {
      length += (far_end(bone) - joints_.origins[bone]).norm();
    }
    if (!(length >= kShortestHandM && length <= kLongestHandM)) {
      fail("metres_per_unit", fmt::format("a hand of {} to {} m", kShortestHandM, kLongestHandM),
           fmt::format("{:.4g} m", length));
    }
  }

  // Two joints at one place or in the wrong order give bones of no length, or that fold back.
  void check_chain(int digit) const {
    Vector3d before = Vector3d::Zero();
    for (int bone = first_bone(digit); bone <= distal_bone(digit); ++bone) {
      const bool is_last = bone == distal_bone(digit);
      const std::string key = is_last ? tip_key(digit) : bone_key(bone + 1);
      const Vector3d along = far_end(bone) - joints_.origins[bone];
      if (!(along.norm() >= kShortestBoneM)) {
        fail(key, fmt::format("a joint at least {} m beyond {}", kShortestBoneM, bone_key(bone)),
             fmt::format("{:.4g} m", along.norm()));
      }
      if (along.normalized().dot(before) < std::cos(kLargestRestBend)) {
        fail(key, fmt::format("a joint beyond {}", bone_key(bone)), "one that lies before it");
      }
      before = along.normalized();
    }
  }

  const RigMap& map_;
  const RigFile& file_;
  Eigen::DiagonalMatrix<double, 3> meters_from_file_;
  RestJoints joints_;
};

}  // namespace

Eigen::DiagonalMatrix<double, 3> meters_from_file(const RigMap& map) {
  const double unit = map.meters_per_unit;
  return Eigen::DiagonalMatrix<double, 3>(map.is_left ? -unit : unit, unit, unit);
}

RestJoints rest_joints(const RigMap& map, const RigFile& file) {
  return JointReader(map, file).read();
}

}  // namespace graspdb
