// SPDX-License-Identifier: MIT
// A skinned hand: its skeleton, its skin in the bind pose, and the skin in any other pose.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "graspdb/core/mesh.h"
#include "graspdb/hand/skeleton.h"

namespace graspdb {

// Up to four bones move a vertex; weights are >= 0 and sum to 1, unused ones are 0.
struct SkinWeights {
  std::array<std::uint8_t, 4> bone{};
  std::array<float, 4> weight{};
};

// A right hand; a left one is mirrored when it is loaded.
struct Hand {
  std::string name;             // e.g. "male"
  std::string origin, license;  // of its file, as the rig map states them; may be empty
  Skeleton skeleton;
  Mesh bind_mesh;                    // hand frame, metres
  std::vector<SkinWeights> weights;  // one a vertex
  PerBone<RigidTransform> hand_from_bone_at_bind;
};

// The skin at these angles by linear blending, in the hand frame. Pure and thread-safe.
Mesh pose_skin(const Hand& hand, const PerBone<RigidTransform>& hand_from_bone);
Mesh pose_skin(const Hand& hand, const JointAngles& angles);

// The bone with the largest weight of every vertex.
std::vector<std::uint8_t> strongest_bones(const Hand& hand);

}  // namespace graspdb
