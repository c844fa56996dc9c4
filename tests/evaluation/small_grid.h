// SPDX-License-Identifier: MIT
// A tiny database, poses x views of the toy hand, and frames that are none of its rows.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "graspdb/core/random.h"
#include "graspdb/evaluation/baselines.h"
#include "graspdb/tracker/pose_vector.h"
#include "support/temporary_directory.h"
#include "support/toy_skeleton.h"

namespace graspdb::testing {

inline JointAngles random_angles(RandomStream& random) {
  return JointAngles::NullaryExpr([&] { return random.uniform(0, 0.8); });
}

inline Eigen::Matrix3d random_rotation(RandomStream& random) {
  return rotation_from_vector({random.normal(), random.normal(), random.normal()});
}

// Twelve views; two grasps of three steps, with the object and without.
class SmallGrid : public ::testing::Test {
 protected:
  static constexpr int kViews = 12, kSteps = 3, kGrasps = 2, kVariants = 2, kFrames = 7;
  static constexpr Intrinsics kCamera{
      .width = 640, .height = 480, .fx = 600, .fy = 600, .cx = 319.5, .cy = 239.5};

  SmallGrid() {
    write_database(directory_ / "grid.graspdb", info(), rows());
    database_.emplace(Database::open(directory_ / "grid.graspdb"));
    grid_.emplace(*database_);
    RandomStream random(6);
    for (int i = 0; i < kFrames; ++i) truth_.push_back(frame(random));
  }

  static DatabaseInfo info() {
    return {.grasps = {{1, "one"}, {16, "sixteen"}},
            .hands = {{"toy", toy_skeleton()}},
            .variants = {"held", "free"},
            .steps = kSteps,
            .views = kViews,
            .camera_distance = 0.7,
            .view_rule = "random",
            .hog = "paper",
            .config = "{}",
            .tool = "test"};
  }

  static std::vector<Row> rows() {
    std::vector<Row> rows;
    for (int variant = 0; variant < kVariants; ++variant) {
      RandomStream random(5);  // the same poses in both
      std::vector<Eigen::Matrix3d> views;
      for (int v = 0; v < kViews; ++v) views.push_back(random_rotation(random));
      for (int pose = 0; pose < kGrasps * kSteps; ++pose) {
        const JointAngles angles = random_angles(random);
        for (int v = 0; v < kViews; ++v) {
          rows.push_back(row(views[static_cast<std::size_t>(v)], angles));
          rows.back().view = static_cast<std::uint32_t>(v);
          rows.back().grasp = pose < kSteps ? 1 : 16;
          rows.back().step = static_cast<std::uint8_t>(pose % kSteps + 1);
          rows.back().variant = static_cast<std::uint8_t>(variant);
        }
      }
    }
    return rows;
  }

  static Row row(const Eigen::Matrix3d& rotation, const JointAngles& angles) {
    Row row;
    Eigen::Map<Eigen::Vector3f>(row.label.data()) = vector_from_rotation(rotation).cast<float>();
    Eigen::Map<Eigen::Matrix<float, kAngleCount, 1>>(row.label.data() + 3) = angles.cast<float>();
    return row;
  }

  static Target frame(RandomStream& random) {
    Target target;
    target.camera = kCamera;
    Pose& pose = target.pose;
    pose.rotation = random_rotation(random);
    pose.angles = random_angles(random);
    const Eigen::Vector3d wrist(random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), 0.6);
    // Another size than the database's hand.
    pose.joints =
        (1.15 * pose.rotation * keypoints_in_hand(toy_skeleton(), pose.angles)).colwise() + wrist;
    return target;
  }

  TemporaryDirectory directory_;
  std::optional<Database> database_;
  std::optional<PoseGrid> grid_;
  std::vector<Target> truth_;
};

}  // namespace graspdb::testing
