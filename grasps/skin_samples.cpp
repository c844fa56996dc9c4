// SPDX-License-Identifier: MIT
#include "skin_samples.h"

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr int kPalmLengthBone = finger_bone(1, kProximal);  // the palm ends at the middle knuckle
constexpr double kBackOfTheHand = 0.6;  // cosine to dorsal beyond which skin meets nothing
constexpr double kFacing = 0.5;         // ... to an area's side, from which skin belongs to it

bool is_finger_metacarpal(int bone) {
  return bone >= kFirstFingerBone && (bone - kFirstFingerBone) % 4 == kMetacarpal;
}

}  // namespace

int digit_of_bone(int bone) {
  if (bone == kForearm) return -1;
  if (bone == kPalm || is_finger_metacarpal(bone)) return 0;
  if (bone < kFirstFingerBone) return with_palm(0);
  return with_palm(digit_of_finger((bone - kFirstFingerBone) / 4));
}

bool is_phalanx(int bone) {
  return digit_of_bone(bone) > 0 && bone != kThumbMetacarpal;
}

Eigen::Vector3d bone_end(const Skeleton& skeleton, int bone) {
  GRASPDB_CHECK(bone != kForearm);
  const auto& zero = skeleton.hand_from_bone_at_zero;
  const auto index = static_cast<std::size_t>(bone);
  if (bone == kPalm) return zero[kPalmLengthBone].translation;
  if (bone == kThumbDistal) return skeleton.tip_in_distal[0];
  const int phalanx = (bone - kFirstFingerBone) % 4;
  if (bone >= kFirstFingerBone && phalanx == kDistal) {
    return skeleton.tip_in_distal[static_cast<std::size_t>(without_palm(digit_of_bone(bone)))];
  }
  return zero[index].inverse() * zero[index + 1].translation;
}

Eigen::Vector3d outward(SkinSide side) {
  if (side == SkinSide::kPalmar) return {0, 0, -1};
  return {side == SkinSide::kRadial ? -1.0 : 1.0, 0, 0};
}

SkinSamples::SkinSamples(const Hand& hand, int stride) {
  const std::vector<std::uint8_t> strongest = strongest_bones(hand);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    bone_at_bind_from_hand_[bone] = hand.hand_from_bone_at_bind[bone].inverse();
  }
  std::array<int, kPalmAndDigitCount> seen{};
  for (std::size_t v = 0; v < strongest.size(); ++v) {
    const int digit = digit_of_bone(strongest[v]);
    if (digit < 0) continue;
    // The palm is one plate: its metacarpals bend too little to matter for what part of it this is.
    const int bone = digit == 0 ? static_cast<int>(kPalm) : strongest[v];
    const RigidTransform& bone_from_hand = bone_at_bind_from_hand_[static_cast<std::size_t>(bone)];
    const Eigen::Vector3d bind = hand.bind_mesh.vertices[v].cast<double>();
    const Eigen::Vector3d normal =
        bone_from_hand.rotation * hand.bind_mesh.normals[v].cast<double>();
    if (normal.z() > kBackOfTheHand) continue;
    if (seen[static_cast<std::size_t>(digit)]++ % stride != 0) continue;
    const double along = (bone_from_hand * bind).y() / bone_end(hand.skeleton, bone).y();
    samples_.push_back({digit, bone, along, normal, bind, hand.weights[v]});
  }
}

std::vector<int> SkinSamples::in_area(const ContactArea& area) const {
  std::vector<int> found;
  const Eigen::Vector3d direction = outward(area.side);
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (sample.bone != area.bone || sample.along < area.from || sample.along > area.to) continue;
    if (sample.normal.dot(direction) > kFacing) found.push_back(static_cast<int>(i));
  }
  return found;
}

std::vector<Eigen::Vector3d> SkinSamples::pose(
    const PerBone<RigidTransform>& hand_from_bone) const {
  PerBone<RigidTransform> posed_from_bind;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    posed_from_bind[bone] = hand_from_bone[bone] * bone_at_bind_from_hand_[bone];
  }
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(samples_.size());
  for (const Sample& sample : samples_) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 4 && sample.weights.weight[i] > 0; ++i) {
      position +=
          sample.weights.weight[i] * (posed_from_bind[sample.weights.bone[i]] * sample.bind);
    }
    positions.push_back(position);
  }
  return positions;
}

}  // namespace graspdb
