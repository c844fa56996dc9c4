// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "graspdb/evaluate.h"
#include "graspdb/random.h"
#include "support/temporary_directory.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

constexpr int kViews = 12, kPoses = 3;

JointAngles random_angles(RandomStream& random) {
  return JointAngles::NullaryExpr([&] { return random.uniform(0, 0.8); });
}

Eigen::Matrix3d random_rotation(RandomStream& random) {
  return rotation_from_vector({random.normal(), random.normal(), random.normal()});
}

// Three poses seen from the same twelve views, and frames that are none of them.
class SmallGrid : public ::testing::Test {
 protected:
  SmallGrid() {
    RandomStream random(5);
    std::vector<Eigen::Matrix3d> views;
    for (int v = 0; v < kViews; ++v) views.push_back(random_rotation(random));
    std::vector<Row> rows;
    for (int p = 0; p < kPoses; ++p) {
      const JointAngles angles = random_angles(random);
      for (int v = 0; v < kViews; ++v)
        rows.push_back(row(views[static_cast<std::size_t>(v)], angles, v, p));
    }
    write_database(directory_ / "grid.graspdb", info(), rows);
    database_.emplace(Database::open(directory_ / "grid.graspdb"));
    for (int i = 0; i < 7; ++i) truth_.push_back(frame(random));
  }

  static DatabaseInfo info() {
    return {.grasps = {{1, "one"}},
            .hands = {{"toy", testing::toy_skeleton()}},
            .variants = {"free"},
            .steps = kPoses,
            .views = kViews,
            .camera_distance = 0.7,
            .view_rule = "random",
            .hog = "paper",
            .config = "{}",
            .tool = "test"};
  }
  static Row row(const Eigen::Matrix3d& rotation, const JointAngles& angles, int view, int pose) {
    Row row;
    Eigen::Map<Eigen::Vector3f>(row.label.data()) = vector_from_rotation(rotation).cast<float>();
    Eigen::Map<Eigen::Matrix<float, kAngleCount, 1>>(row.label.data() + 3) = angles.cast<float>();
    row.view = static_cast<std::uint32_t>(view);
    row.grasp = 1;
    row.step = static_cast<std::uint8_t>(pose + 1);
    return row;
  }
  static FrameTruth frame(RandomStream& random) {
    FrameTruth truth;
    truth.camera_from_hand = random_rotation(random);
    truth.angles = random_angles(random);
    truth.wrist = {random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), 0.6};
    truth.joints =
        (truth.camera_from_hand * keypoints_in_palm(testing::toy_skeleton(), truth.angles))
            .colwise() +
        truth.wrist;
    return truth;
  }
  // What a tracker would answer with this row.
  Pose answer(std::size_t row, const FrameTruth& truth) const {
    const Eigen::Vector3d palm =
        truth.wrist + truth.camera_from_hand * palm_centre(testing::toy_skeleton(), truth.angles);
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), palm).toRotationMatrix();
    const JointAngles angles = label_angles(database_->label(row));
    const Eigen::Matrix3d rotation = turn * label_rotation(database_->label(row));
    return {rotation, angles, rotation * keypoints_in_palm(testing::toy_skeleton(), angles)};
  }

  testing::TemporaryDirectory directory_;
  std::optional<Database> database_;
  std::vector<FrameTruth> truth_;
};

TEST_F(SmallGrid, TheOracleIsTheBestOfAllRowsForEachMetric) {
  std::vector<FrameErrors> best;
  for (const FrameTruth& truth : truth_) {
    FrameErrors least{1e9, 1e9, 1e9, 1e9, 1e9};
    for (std::size_t row = 0; row < database_->rows(); ++row) {
      const FrameErrors errors = compare(answer(row, truth), pose_of(truth));
      least.pose = std::min(least.pose, errors.pose);
      least.rotation_deg = std::min(least.rotation_deg, errors.rotation_deg);
      least.joint_deg = std::min(least.joint_deg, errors.joint_deg);
      least.mpjpe_mm = std::min(least.mpjpe_mm, errors.mpjpe_mm);
      least.pa_mpjpe_mm = std::min(least.pa_mpjpe_mm, errors.pa_mpjpe_mm);
    }
    best.push_back(least);
  }
  const Summary wanted = summarize(best), found = baselines(*database_, truth_, 0).oracle;
  EXPECT_NEAR(found.pose_error, wanted.pose_error, 1e-6);
  EXPECT_NEAR(found.rotation_deg.mean, wanted.rotation_deg.mean, 1e-4);
  EXPECT_NEAR(found.joint_deg, wanted.joint_deg, 1e-6);
  EXPECT_NEAR(found.mpjpe_mm, wanted.mpjpe_mm, 1e-4);
  EXPECT_NEAR(found.pa_mpjpe_mm, wanted.pa_mpjpe_mm, 1e-4);
}

TEST_F(SmallGrid, TheConstantGuessIsTheRowWithTheSmallestMeanTurn) {
  double least = 1e9;
  for (std::size_t row = 0; row < kViews; ++row) {
    double sum = 0;
    for (const FrameTruth& truth : truth_)
      sum += compare(answer(row, truth), pose_of(truth)).rotation_deg;
    least = std::min(least, sum / static_cast<double>(truth_.size()));
  }
  EXPECT_NEAR(baselines(*database_, truth_, 0).constant.rotation_deg.mean, least, 1e-4);
}

TEST_F(SmallGrid, NoRowIsBetterThanTheOracleAndARandomRowIsWorse) {
  const Baselines base = baselines(*database_, truth_, 3);
  EXPECT_LT(base.oracle.pose_error, base.constant.pose_error);
  EXPECT_LT(base.constant.rotation_deg.mean, base.random.rotation_deg.mean);
  EXPECT_EQ(base.nearest_pose_deg.mean, base.oracle.joint_deg);
}

}  // namespace
}  // namespace graspdb
