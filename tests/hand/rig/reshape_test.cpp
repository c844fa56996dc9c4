// SPDX-License-Identifier: MIT
// What the loader does to a foreign skin when its rig map asks for it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "graspdb/core/transform.h"
#include "rebind.h"
#include "subdivide.h"
#include "support/closed_surface.h"
#include "support/compare_hands.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

// A sphere of radius 1 in eight triangles.
RigSkin octahedron() {
  RigSkin skin;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {1.F, -1.F}) {
      skin.mesh.vertices.push_back(side * Eigen::Vector3f::Unit(axis));
      skin.mesh.normals.push_back(side * Eigen::Vector3f::Unit(axis));
      skin.mesh.albedo.push_back(side > 0 ? 1.F : 0.F);
      PerBone<double> weights{};
      weights[static_cast<std::size_t>(axis)] = 1;
      skin.weights.push_back(weights);
    }
  }
  skin.mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                         {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return skin;
}

TEST(Subdivide, LeavesNoLongEdgeAndAClosedSurfaceThatKeepsTheOldVertices) {
  const RigSkin coarse = octahedron();
  for (const double limit : {1.5, 1., .3}) {
    RigSkin fine = coarse;
    subdivide(limit, fine);
    EXPECT_TRUE(testing::is_closed_surface(fine.mesh));
    for (std::size_t v = 0; v < coarse.mesh.vertices.size(); ++v) {
      EXPECT_EQ(fine.mesh.vertices[v], coarse.mesh.vertices[v]);
    }
    for (const Triangle& t : fine.mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto edge = fine.mesh.vertices[t[i]] - fine.mesh.vertices[t[(i + 1) % 3]];
        EXPECT_LE(edge.norm(), limit);
      }
    }
    for (const PerBone<double>& weights : fine.weights) {
      EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1, 1e-12);
    }
  }
}

TEST(Subdivide, RoundsWhatTheNormalsSayIsRound) {
  RigSkin fine = octahedron();
  const double flat = testing::volume(fine.mesh), sphere = 4. / 3 * kPi;
  subdivide(.3, fine);
  EXPECT_GT(testing::volume(fine.mesh), flat + .5 * (sphere - flat));
  EXPECT_LT(testing::volume(fine.mesh), sphere * 1.05);
}

// A hand bound flat: one vertex over the index's PIP joint, which both its phalanges move, and one
// on the middle phalanx.
Hand flat_hand() {
  Hand hand;
  hand.skeleton = testing::toy_skeleton();
  hand.hand_from_bone_at_bind = hand_from_bones(hand.skeleton, JointAngles::Zero());
  const auto proximal = static_cast<std::uint8_t>(finger_bone(0, kProximal));
  const auto middle = static_cast<std::uint8_t>(finger_bone(0, kMiddle));
  const Eigen::Vector3d joint = hand.hand_from_bone_at_bind[middle].translation;
  hand.bind_mesh.vertices = {(joint + Eigen::Vector3d(0, 0, .008)).cast<float>(),
                             (joint + Eigen::Vector3d(0, .01, .008)).cast<float>()};
  hand.bind_mesh.normals = {Eigen::Vector3f::UnitZ(), Eigen::Vector3f::UnitZ()};
  hand.weights = {{{proximal, middle}, {.5F, .5F}}, {{middle}, {1}}};
  return hand;
}

double thickness(const Hand& hand, double flexion) {
  JointAngles angles = JointAngles::Zero();
  angles[finger_angle(0, kPipFlexion)] = flexion;
  const PerBone<RigidTransform> frames = hand_from_bones(hand.skeleton, angles);
  return (pose_skin(hand, frames).vertices[0].cast<double>() -
          frames[finger_bone(0, kMiddle)].translation)
      .norm();
}

TEST(BoundHalfBent, KeepsTheThicknessOfAJointWhereItIsBoundAndMostOfItElsewhere) {
  const Hand flat = flat_hand(), bent = bound_half_bent(flat_hand());
  const double bend = radians(60);
  EXPECT_NEAR(thickness(bent, bend), .008, 1e-6);
  EXPECT_NEAR(thickness(flat, radians(105)), .008 * std::cos(radians(52.5)), 1e-6);
  EXPECT_NEAR(thickness(bent, radians(105)), .008 * std::cos(radians(22.5)), 1e-6);
  EXPECT_NEAR(thickness(bent, 0), .008 * std::cos(radians(30)), 1e-6);
}

TEST(BoundHalfBent, MovesNoJointAndNoSkinOfOneBone) {
  const Hand flat = flat_hand(), bent = bound_half_bent(flat_hand());
  EXPECT_EQ(testing::largest_difference(flat.skeleton, bent.skeleton), 0);
  for (const double angle : {-.1, 0., .3, .8}) {
    const JointAngles angles = JointAngles::Constant(angle);
    const Mesh before = pose_skin(flat, angles), after = pose_skin(bent, angles);
    EXPECT_LT((before.vertices[1] - after.vertices[1]).norm(), 1e-6);
    EXPECT_LT((before.normals[1] - after.normals[1]).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace graspdb
