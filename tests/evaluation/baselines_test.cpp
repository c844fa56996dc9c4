// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/baselines.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "small_grid.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

class BaselinesOfASmallGrid : public testing::SmallGrid {
 protected:
  // What a tracker would answer with this row, straight from the database.
  Answer answer(std::size_t row, const Target& truth) const {
    const Keypoints& joints = truth.pose.joints;
    const Eigen::Vector3d palm =
        (joints.col(0) + joints.col(5) + joints.col(9) + joints.col(13) + joints.col(17)) / 5;
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), palm).toRotationMatrix();
    const JointAngles angles = unpack_label(database_->label(row)).angles;
    const Eigen::Matrix3d rotation = turn * unpack_label(database_->label(row)).rotation;
    const Skeleton skeleton = testing::toy_skeleton();
    const Eigen::Vector3d wrist = palm - rotation * palm_center(skeleton, angles);
    return {{rotation, angles, (rotation * keypoints_in_hand(skeleton, angles)).colwise() + wrist},
            {{database_->grasp(row), 1.0}}};
  }

  std::vector<FrameErrors> all_rows(const Target& truth) const {
    std::vector<FrameErrors> all;
    for (std::size_t row = 0; row < database_->rows(); ++row)
      all.push_back(compare(answer(row, truth), truth));
    return all;
  }
};

TEST_F(BaselinesOfASmallGrid, TheOracleIsTheBestOfAllRowsForEachMetric) {
  for (Target& truth : truth_) {
    truth.grasp_type = &truth == &truth_.front() ? 16 : 29;  // 29 is merged with 16
    const std::vector<FrameErrors> rows = all_rows(truth);
    const FrameErrors found = oracle(*grid_, truth).errors;
    for (std::size_t m = 0; m < kMetricCount; ++m) {
      const MetricInfo& info = metric_info(static_cast<int>(m));
      const auto less = [m](const FrameErrors& a, const FrameErrors& b) { return a[m] < b[m]; };
      const double best = info.more_is_better
                              ? (*std::max_element(rows.begin(), rows.end(), less))[m]
                              : (*std::min_element(rows.begin(), rows.end(), less))[m];
      EXPECT_NEAR(found[m], best, 1e-6) << info.name;
    }
  }
}

TEST_F(BaselinesOfASmallGrid, TheOracleNamesTheRowThatGivesIt) {
  for (const Target& truth : truth_) {
    const FrameOracle best = oracle(*grid_, truth);
    const auto seen = [&](const GridPlace& place) {
      return compare({grid_->seen(place.pose, place.view, truth.pose), {}}, truth);
    };
    EXPECT_NEAR(seen(best.best_pose_error)[kPoseError], best.errors[kPoseError], 1e-9);
    EXPECT_NEAR(seen(best.best_mpjpe)[kMpjpeMm], best.errors[kMpjpeMm], 1e-9);
  }
}

TEST_F(BaselinesOfASmallGrid, ARowSeenByTheGridIsTheDatabasesRow) {
  for (const std::uint32_t row : {0U, 17U, 71U, 100U}) {
    const Pose seen = grid_->seen(grid_->pose_of(row), grid_->view_of(row), truth_[0].pose);
    const Pose expected = answer(row, truth_[0]).pose;
    EXPECT_LT((seen.joints - expected.joints).norm(), 1e-12);
    EXPECT_LT((seen.rotation - expected.rotation).norm(), 1e-12);
    EXPECT_EQ(seen.angles, expected.angles);
  }
}

TEST_F(BaselinesOfASmallGrid, APoseOfBothVariantsIsKeptOnce) {
  EXPECT_EQ(grid_->rows(), database_->rows());
  EXPECT_EQ(grid_->poses().size(), std::size_t{kGrasps * kSteps});
  EXPECT_EQ(grid_->views().size(), std::size_t{kViews});
}

TEST_F(BaselinesOfASmallGrid, ADatabaseThatIsNoGridIsRefused) {
  std::vector<Row> odd = rows();
  odd[kViews + 3].label[10] += 0.1F;
  write_database(directory_ / "odd.graspdb", info(), odd);
  try {
    const PoseGrid grid(Database::open(directory_ / "odd.graspdb"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("row 15"));
  }
}

TEST_F(BaselinesOfASmallGrid, TheConstantGuessIsTheRowWithTheSmallestMeanTurn) {
  double least = 1e9;
  for (std::size_t row = 0; row < kViews; ++row) {
    double sum = 0;
    for (const Target& truth : truth_) sum += compare(answer(row, truth), truth)[kRotationDeg];
    least = std::min(least, sum / static_cast<double>(truth_.size()));
  }
  EXPECT_NEAR(baselines(*grid_, truth_, 0).constant.mean[kRotationDeg], least, 1e-4);
}

TEST_F(BaselinesOfASmallGrid, NoRowIsBetterThanTheOracleAndARandomRowIsWorse) {
  const Baselines base = baselines(*grid_, truth_, 3);
  EXPECT_LT(base.oracle_mean.mean[kPoseError], base.constant.mean[kPoseError]);
  EXPECT_LT(base.constant.mean[kRotationDeg], base.random.mean[kRotationDeg]);
  EXPECT_TRUE(std::isnan(base.random.mean[kGraspTop1]));  // no type was asked for
}

TEST_F(BaselinesOfASmallGrid, TheJitterIsThatOfTheRowsTheyName) {
  std::vector<Keypoints> best, truth;
  for (const Target& frame : truth_) {
    const GridPlace place = oracle(*grid_, frame).best_mpjpe;
    best.push_back(grid_->seen(place.pose, place.view, frame.pose).joints);
    truth.push_back(frame.pose.joints);
  }
  const Baselines base = baselines(*grid_, truth_, 3);
  EXPECT_NEAR(base.oracle_mean.mean[kUnsteadinessMm], unsteadiness_mm(best, truth), 1e-9);
  EXPECT_GT(base.random.mean[kUnsteadinessMm], base.oracle_mean.mean[kUnsteadinessMm]);
  EXPECT_GT(base.constant.mean[kUnsteadinessMm], 0);
}

TEST_F(BaselinesOfASmallGrid, ARandomRowHasTheMeanErrorOfAllRows) {
  std::vector<FrameErrors> all;
  for (Target& truth : truth_) {
    truth.grasp_type = 16;
    const std::vector<FrameErrors> rows = all_rows(truth);
    all.insert(all.end(), rows.begin(), rows.end());
  }
  const RunErrors expected = summarize(all).mean;
  const RunErrors found = baselines(*grid_, truth_, 3).random.mean;
  EXPECT_NEAR(found[kRotationDeg] / expected[kRotationDeg], 1, 0.15);
  EXPECT_NEAR(found[kMpjpeMm] / expected[kMpjpeMm], 1, 0.15);
  EXPECT_NEAR(found[kGraspTop1], 0.5, 0.1);  // one of two types
  EXPECT_EQ(found[kGraspTop5], 1);
}

}  // namespace
}  // namespace graspdb
