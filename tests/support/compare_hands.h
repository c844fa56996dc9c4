// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "graspdb/hand/hand.h"

namespace graspdb::testing {

inline double largest_difference(const Skeleton& a, const Skeleton& b) {
  double largest = 0;
  for (std::size_t i = 0; i < kBoneCount; ++i) {
    const RigidTransform &p = a.hand_from_bone_at_zero[i], &q = b.hand_from_bone_at_zero[i];
    largest = std::max({largest, (p.rotation - q.rotation).cwiseAbs().maxCoeff(),
                        (p.translation - q.translation).cwiseAbs().maxCoeff()});
  }
  for (std::size_t i = 0; i < 5; ++i) {
    largest = std::max(largest, (a.tip_in_distal[i] - b.tip_in_distal[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

// The same number of vertices is expected.
inline double largest_difference(const Mesh& a, const Mesh& b) {
  double largest = a.vertices.size() == b.vertices.size() ? 0 : 1e9;
  for (std::size_t v = 0; v < std::min(a.vertices.size(), b.vertices.size()); ++v) {
    largest = std::max<double>(largest, (a.vertices[v] - b.vertices[v]).cwiseAbs().maxCoeff());
  }
  return largest;
}

inline PerBone<float> weight_of_bones(const SkinWeights& skin) {
  PerBone<float> weights{};
  for (std::size_t i = 0; i < 4; ++i) weights[skin.bone[i]] += skin.weight[i];
  return weights;
}

// Joints, frames and skin within a micrometre.
inline void expect_same_hand(const Hand& a, const Hand& b) {
  EXPECT_LT(largest_difference(a.skeleton, b.skeleton), 1e-6);
  EXPECT_LT(largest_difference(a.bind_mesh, b.bind_mesh), 1e-6);
  EXPECT_TRUE(a.bind_mesh.triangles == b.bind_mesh.triangles);
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    const RigidTransform &p = a.hand_from_bone_at_bind[bone], &q = b.hand_from_bone_at_bind[bone];
    EXPECT_LT(angle_between(p.rotation, q.rotation), 1e-5) << bone_name(static_cast<int>(bone));
    EXPECT_LT((p.translation - q.translation).norm(), 1e-6) << bone_name(static_cast<int>(bone));
  }
  ASSERT_EQ(a.weights.size(), b.weights.size());
  for (std::size_t v = 0; v < a.weights.size(); ++v) {
    const PerBone<float> p = weight_of_bones(a.weights[v]), q = weight_of_bones(b.weights[v]);
    for (std::size_t bone = 0; bone < kBoneCount; ++bone) ASSERT_NEAR(p[bone], q[bone], 1e-6);
  }
}

}  // namespace graspdb::testing
