// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/gap.h"

#include "small_grid.h"

namespace graspdb {
namespace {

double joint_distance_mm(const Pose& a, const Pose& b) {
  return mpjpe_mm(a.joints, b.joints);
}

class GapOfASmallGrid : public testing::SmallGrid {
 protected:
  double error(std::uint32_t row) const { return pose_error(seen(row), truth_[0].pose); }
  Pose seen(std::uint32_t row) const {
    return grid_->seen(grid_->pose_of(row), grid_->view_of(row), truth_[0].pose);
  }
  Gap split(const Pose& answer, const std::vector<std::uint32_t>& rows) const {
    return split_gap({*grid_, truth_[0].pose, answer, hypotheses(rows), best_.best_pose_error},
                     pose_error);
  }
  static std::vector<Hypothesis> hypotheses(const std::vector<std::uint32_t>& rows) {
    std::vector<Hypothesis> all;
    for (const std::uint32_t row : rows) all.push_back({.row = row});
    return all;
  }
  FrameOracle best_ = oracle(*grid_, truth_[0]);
};

TEST_F(GapOfASmallGrid, RetrievalAndChoiceAreWhatTheBestRetrievedRowDivides) {
  const std::vector<std::uint32_t> rows = {3, 40, 17, 66};
  double retrieved = 1e9;
  for (const std::uint32_t row : rows) retrieved = std::min(retrieved, error(row));
  ASSERT_LT(retrieved, error(3));  // else there is nothing to choose
  const Gap gap = split(seen(3), rows);
  EXPECT_NEAR(gap.retrieval, retrieved - best_.errors[kPoseError], 1e-9);
  EXPECT_NEAR(gap.choice, error(3) - retrieved, 1e-12);
  EXPECT_EQ(gap.placement, 0);
  EXPECT_EQ(gap.unanswered, 0);
}

TEST_F(GapOfASmallGrid, BothSplitsAddUpToTheGap) {
  for (const std::uint32_t row : {3U, 40U, 71U}) {
    Pose answer = seen(row);
    const Eigen::Matrix3d off = axis_rotation(0, 0.1);  // placed a little wrong
    answer.rotation = off * answer.rotation;
    answer.joints = off * answer.joints;
    const std::vector<Hypothesis> rows = hypotheses({row, 5});
    for (const PoseMetric metric : {PoseMetric{pose_error}, PoseMetric{joint_distance_mm}}) {
      const bool is_pose = metric == PoseMetric{pose_error};
      const GridPlace place = is_pose ? best_.best_pose_error : best_.best_mpjpe;
      const double oracle = best_.errors[is_pose ? kPoseError : kMpjpeMm];
      const double whole = metric(answer, truth_[0].pose) - oracle;
      const Gap gap = split_gap({*grid_, truth_[0].pose, answer, rows, place}, metric);
      EXPECT_NEAR(gap.total(), whole, 1e-9);
      EXPECT_NEAR(gap.view + gap.pose, whole, 1e-9);
      EXPECT_NE(gap.placement, 0);
    }
  }
}

TEST_F(GapOfASmallGrid, AnAnswerWithTheBestPoseLacksTheViewOnly) {
  GridPlace place = best_.best_pose_error;
  place.view = (place.view + 1) % grid_->views().size();
  const Gap gap = split(grid_->seen(place.pose, place.view, truth_[0].pose), {});
  EXPECT_NEAR(gap.pose, 0, 1e-9);
  EXPECT_GT(gap.view, 0.01);
}

TEST_F(GapOfASmallGrid, AHypothesisOfARolledLookIsTurnedBack) {
  const Pose& truth = truth_[0].pose;
  const Pose answer = grid_->seen(grid_->pose_of(3), grid_->view_of(3), truth, 30);
  const Eigen::Matrix3d turn = answer.rotation * seen(3).rotation.transpose();
  const Eigen::Vector3d ray = palm_center(truth.joints).normalized();
  EXPECT_LT((vector_from_rotation(turn) + radians(30) * ray).norm(), 1e-9);
  EXPECT_LT((palm_center(answer.joints) - palm_center(truth.joints)).norm(), 1e-9);
  for (const double roll_deg : {0.0, 30.0}) {
    const std::vector<Hypothesis> found = {{.row = 3, .roll_deg = roll_deg}};
    const Gap gap =
        split_gap({*grid_, truth, answer, found, best_.best_pose_error}, joint_distance_mm);
    EXPECT_EQ(std::abs(gap.placement) < 1e-9, roll_deg == 30);
  }
}

TEST_F(GapOfASmallGrid, WithoutAnAnswerTheWholeGapIsThat) {
  const Gap gap = split(seen(9), {});
  EXPECT_NEAR(gap.unanswered, error(9) - best_.errors[kPoseError], 1e-9);
  EXPECT_EQ(gap.retrieval, 0);
  EXPECT_EQ(gap.choice, 0);
}

TEST_F(GapOfASmallGrid, TheBestRowHasNone) {
  const GridPlace& place = best_.best_pose_error;
  const auto row = static_cast<std::uint32_t>(place.pose * kViews + place.view);
  const Gap gap = split(seen(row), {row, 1});
  for (const double part : {gap.retrieval, gap.choice, gap.placement, gap.view, gap.pose})
    EXPECT_NEAR(part, 0, 1e-9);
}

TEST(Gap, TheMeanIsOverFramesPartByPart) {
  const Gap mean = mean_gap({{.retrieval = 2, .view = 1}, {.choice = 4, .pose = 3}});
  EXPECT_EQ(mean.retrieval, 1);
  EXPECT_EQ(mean.choice, 2);
  EXPECT_EQ(mean.view, 0.5);
  EXPECT_EQ(mean.pose, 1.5);
  EXPECT_EQ(mean_gap({}).total(), 0);
}

}  // namespace
}  // namespace graspdb
