// SPDX-License-Identifier: MIT
// Runs over frames that are the rows of a small database themselves.
#include "graspdb/evaluation/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>

#include "graspdb/generator/generator.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using testing::kSource;
constexpr int kViews = 24, kFrames = 15;

class RowsAsFrames : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = std::make_unique<testing::TemporaryDirectory>();
    BuildConfig config;
    config.hands = {kSource / "assets/hands/male.glb"};
    config.grasps = kSource / "grasps";
    config.only = {14};
    config.objects = Objects::kFree;
    config.steps = 1;
    config.views = kViews;
    build_database(config, {.out = *directory_ / "small.graspdb"});
    database_.emplace(Database::open(*directory_ / "small.graspdb"));
    grid_.emplace(*database_);
    search_ = make_exact_search(*database_);
    make_frames(config);
  }
  static void TearDownTestSuite() {
    search_.reset();
    grid_.reset();
    database_.reset();
    directory_.reset();
  }

  // Rows as they are, on the axis, one after another.
  static void make_frames(const BuildConfig& config) {
    frames_ = {
        .name = "rows",
        .grasp_type = 14,
        .camera = {.width = 320, .height = 240, .fx = 500, .fy = 500, .cx = 159.5, .cy = 119.5}};
    const Hand hand = with_visible_forearm(load_hand(config.hands.front()), config.visible_forearm);
    const GraspPose pose = closed_pose(load_grasp(config.grasps / "14_tripod.toml"), hand);
    const PosedScene posed = pose_scene(hand, pose, nullptr);
    for (std::size_t i = 0; i < kFrames; ++i) {
      FrameTruth truth;
      truth.time = 0.1 * static_cast<double>(i);
      truth.closure = i < 5 ? 0.3 : 1;
      auto& [rotation, wrist] = truth.camera_from_hand;
      rotation = unpack_label(database_->label(i)).rotation;
      wrist = Eigen::Vector3d(0, 0, 0.7) - rotation * posed.center;
      truth.angles = pose.angles;
      truth.joints = (rotation * keypoints_in_hand(hand.skeleton, pose.angles)).colwise() + wrist;
      const Camera camera{frames_.camera, truth.camera_from_hand};
      const View view = render(posed.scene, camera, config.light);
      frames_.gray.push_back(view.shading);
      frames_.hand.push_back(visible_hand(view));
      frames_.truth.push_back(truth);
      frames_.occlusion.push_back(0);
    }
  }

  static SequenceEvaluation evaluated(const SequenceFrames& frames) {
    return evaluate(*database_, *grid_, *search_, frames, {.alphas = {0, 3}});
  }

  static std::unique_ptr<testing::TemporaryDirectory> directory_;
  static std::optional<Database> database_;
  static std::optional<PoseGrid> grid_;
  static std::unique_ptr<Search> search_;
  static SequenceFrames frames_;
};
std::unique_ptr<testing::TemporaryDirectory> RowsAsFrames::directory_;
std::optional<Database> RowsAsFrames::database_;
std::optional<PoseGrid> RowsAsFrames::grid_;
std::unique_ptr<Search> RowsAsFrames::search_;
SequenceFrames RowsAsFrames::frames_;

TEST_F(RowsAsFrames, AreFoundAndTheOracleIsPerfect) {
  const SequenceEvaluation result = evaluated(frames_);
  ASSERT_EQ(result.runs.size(), 8U);
  const EvalRun& none = result.runs[0];
  EXPECT_EQ(none.temporal, TemporalModel::kNone);
  EXPECT_EQ(none.alpha, 0);
  EXPECT_EQ(none.valid, 1);
  for (std::size_t i = 0; i < kFrames; ++i) EXPECT_EQ(none.frames[i].row, i);
  EXPECT_LT(none.errors.mean[kRotationDeg], 3);
  EXPECT_LT(none.errors.mean[kError2dPalms], 0.1);
  EXPECT_LT(result.baselines.oracle_mean.mean[kMpjpeMm], 0.01);
  EXPECT_NEAR(none.pose_error_gap.total(), none.errors.mean[kPoseError], 1e-3);
  EXPECT_NEAR(none.pose_error_gap.retrieval, 0, 1e-6);
  EXPECT_EQ(none.errors.mean[kGraspTop1], 1);
  EXPECT_GE(result.runs[1].errors.mean[kPoseError], none.errors.mean[kPoseError]);
}

TEST_F(RowsAsFrames, TheTypeIsAskedForOnceTheHandIsClosed) {
  const SequenceEvaluation result = evaluated(frames_);
  EXPECT_TRUE(std::isnan(result.runs[0].frames[4].errors[kGraspTop1]));
  EXPECT_EQ(result.runs[0].frames[5].errors[kGraspTop1], 1);
  EXPECT_EQ(result.grasping_frames, 10);
  EXPECT_EQ(result.beyond_5_deg, 0);
}

TEST_F(RowsAsFrames, HowWellHandsAreFoundIsAMeanOverTheFramesWhereItApplies) {
  SequenceFrames found = frames_;
  found.found.assign(kFrames, {.iou = 1, .wrist_mm = 10});
  found.found[0] = {.iou = 0, .missed = true};
  found.found[1] = {.iou = 0, .imagined = true};
  found.found[2] = {};  // neither shows a hand
  const FindingMeans means = evaluated(found).found;
  EXPECT_NEAR(means.iou, 12.0 / 14, 1e-12);
  EXPECT_NEAR(means.missed, 1.0 / 13, 1e-12);
  EXPECT_NEAR(means.imagined, 1.0 / 2, 1e-12);
  EXPECT_EQ(means.wrist_mm, 10);
  EXPECT_TRUE(std::isnan(evaluated(frames_).found.iou));
}

// A hand that ends at the wrist is not cut once more: its mask is taken as it is.
TEST_F(RowsAsFrames, AHandThatIsFoundApartFromItsArmIsTakenAsItIs) {
  SequenceFrames apart = frames_;
  const Mask nothing(apart.camera.width, apart.camera.height);
  apart.arm.assign(kFrames, nothing);
  for (int x = 150; x < 170; ++x) apart.hand[4].at(x, 3) = 255;  // isolate_hand would drop it
  const EvalRun run = evaluated(apart).runs[0];
  EXPECT_GT(run.frames[4].box_height_px, evaluated(frames_).runs[0].frames[4].box_height_px + 20);
}

TEST_F(RowsAsFrames, AFrameWithoutAnAnswerCountsWithTheOneBefore) {
  SequenceFrames gap = frames_;
  gap.hand[6] = Mask(gap.camera.width, gap.camera.height);
  const EvalRun run = evaluated(gap).runs[0];
  EXPECT_FALSE(run.frames[6].valid);
  EXPECT_EQ(run.frames[6].box_height_px, 0);
  EXPECT_NEAR(run.frames[6].errors[kRotationDeg],
              degrees(angle_between(gap.truth[5].camera_from_hand.rotation,
                                    gap.truth[6].camera_from_hand.rotation)),
              3);
  EXPECT_GT(run.frames[6].pose_error_gap.unanswered, 0.1);
  EXPECT_EQ(run.frames[6].pose_error_gap.choice, 0);
  EXPECT_NEAR(run.valid, 14.0 / 15, 1e-12);
}

TEST_F(RowsAsFrames, FramesThatAreRightAtOnceAfterTheBlackOnesNeedNone) {
  for (const Recovery& recovery : evaluated(frames_).recoveries) {
    EXPECT_TRUE(recovery.recovered);
    EXPECT_EQ(recovery.frames, 0);
  }
}

TEST_F(RowsAsFrames, RecoveryCountsTheWrongFramesUntilThen) {
  SequenceFrames wrong = frames_;
  // Black are frames 2 to 11; of the three after them the first shows another row than it says.
  wrong.gray[12] = frames_.gray[0];
  wrong.hand[12] = frames_.hand[0];
  ASSERT_GT(rotation_deg(frames_.truth[0].camera_from_hand.rotation,
                         frames_.truth[12].camera_from_hand.rotation),
            kRecoveredDeg + 5);
  EXPECT_EQ(evaluated(wrong).recoveries[0].frames, 1);
  EXPECT_TRUE(evaluated(wrong).recoveries[0].recovered);
  for (const std::size_t i : {13U, 14U})
    wrong.hand[i] = Mask(wrong.camera.width, wrong.camera.height);
  EXPECT_EQ(evaluated(wrong).recoveries[0].frames, 3);  // all that were left
  EXPECT_FALSE(evaluated(wrong).recoveries[0].recovered);
}

TEST_F(RowsAsFrames, AShortSequenceHasNoRecovery) {
  SequenceFrames few = frames_;
  few.gray.resize(kBlackFrames);
  few.hand.resize(kBlackFrames);
  few.truth.resize(kBlackFrames);
  few.occlusion.resize(kBlackFrames);
  EXPECT_TRUE(evaluated(few).recoveries.empty());
}

}  // namespace
}  // namespace graspdb
