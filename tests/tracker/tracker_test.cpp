// SPDX-License-Identifier: MIT
#include "graspdb/tracker/tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/core/error.h"
#include "tracker/bars.h"
#include "tracker/one_row.h"
#include "tracker/plain_options.h"

namespace graspdb {
namespace {

using testing::bar;
using testing::BarPicture;
using testing::kCamera;
using testing::kSide;
using testing::OneRow;

class BarTracker : public testing::BarDatabase {
 protected:
  Tracker tracker(const testing::PlainOptions& options = {}) {
    return {*database_, *search_, options};
  }
};

Estimate show(Tracker& tracker, const BarPicture& picture) {
  return tracker.step({picture.gray, picture.mask, kCamera});
}

TEST_F(BarTracker, ARowsOwnPictureGivesThatRow) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone, .neighbors = 4});
  for (std::size_t row = 0; row < kBars; ++row) {
    const Estimate estimate = show(tracker, bar(angle_of(row)));
    ASSERT_TRUE(estimate.valid);
    EXPECT_EQ(estimate.row, row);
    EXPECT_EQ(estimate.distance, 0);
    EXPECT_GT(estimate.confidence, 0.95);
    EXPECT_EQ(estimate.grasp, row < 4 ? 1 : 2);
    EXPECT_LT(degrees(angle_between(estimate.camera_from_hand.rotation,
                                    rotation_from_vector({0, 0, angle_of(row)}))),
              1);
  }
}

TEST_F(BarTracker, WeightsSumToOneAndTheHeaviestIsFirst) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kKde, .neighbors = 6});
  for (int frame = 0; frame < 3; ++frame) {
    const Estimate estimate = show(tracker, bar(radians(25)));
    double sum = 0;
    for (std::size_t i = 0; i < estimate.hypotheses.size(); ++i) {
      sum += estimate.hypotheses[i].weight;
      if (i > 0) {
        EXPECT_LE(estimate.hypotheses[i].weight, estimate.hypotheses[i - 1].weight);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(estimate.hypotheses.front().row, estimate.row);
    EXPECT_GT(estimate.grasp_probability, 0);
    EXPECT_LE(estimate.grasp_probability, 1 + 1e-12);
  }
}

// Between two rows' angles both weigh alike: their mean is the bar's own, the heaviest is not.
TEST_F(BarTracker, MergedAnswersLieBetweenTheRows) {
  const double between = (angle_of(4) + angle_of(5)) / 2;
  const Eigen::Matrix3d truth = rotation_from_vector({0, 0, between});
  for (const double merge_deg : {0.0, 25.0}) {
    Tracker tracker = this->tracker({.temporal = TemporalModel::kNone,
                                     .sigma_hog = 100,
                                     .sigma_stretch = 10,
                                     .merge_deg = merge_deg});
    const Estimate estimate = show(tracker, bar(between));
    ASSERT_TRUE(estimate.valid);
    const double error = degrees(angle_between(estimate.camera_from_hand.rotation, truth));
    const double share = error / degrees(angle_of(5) - angle_of(4));
    if (merge_deg > 0) {
      EXPECT_LT(share, 0.25);
    } else {
      EXPECT_GT(share, 0.33);
    }
  }
}

// Front or back: the picture does not tell, the past does.
TEST_F(BarTracker, ThePastDecidesWhatThePictureLeavesOpen) {
  for (const TemporalModel model : {TemporalModel::kGaussian, TemporalModel::kKde}) {
    Tracker tracker = this->tracker({.temporal = model, .neighbors = 5, .sigma_hog = 0.3});
    show(tracker, thin());
    EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 8u);
    show(tracker, BarPicture{});  // forgets
    show(tracker, square());
    EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 2u);
  }
  Tracker blind = tracker({.temporal = TemporalModel::kNone, .neighbors = 5, .sigma_hog = 0.3});
  show(blind, thin());
  EXPECT_EQ(show(blind, bar(angle_of(kFlipped))).row, 2u);
}

TEST_F(BarTracker, TheArmDecidesWhatThePictureLeavesOpen) {
  Tracker tracker = this->tracker(
      {.temporal = TemporalModel::kNone, .neighbors = 5, .sigma_hog = 0.3, .sigma_arm_deg = 30});
  const BarPicture picture = bar(angle_of(kFlipped));
  Observation seen{picture.gray, picture.mask, kCamera};
  const double angle = angle_of(kFlipped);  // of the row's hand, which has its arm behind it
  for (const double off_deg : {-30, 0, 30}) {
    const double a = angle + radians(off_deg);
    const Eigen::Vector2d towards_arm(std::sin(a), -std::cos(a));
    seen.towards_arm = towards_arm;
    EXPECT_EQ(tracker.step(seen).row, 2u);
    seen.towards_arm = -towards_arm;
    EXPECT_EQ(tracker.step(seen).row, 8u);
  }
}

TEST_F(BarTracker, AnArmThatIsHardlyTrustedChangesNothing) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone, .sigma_arm_deg = 1000});
  const BarPicture picture = bar(radians(25));
  Observation seen{picture.gray, picture.mask, kCamera};
  const double without = tracker.step(seen).hypotheses.front().weight;
  seen.towards_arm = Eigen::Vector2d(1, 0);
  EXPECT_NEAR(tracker.step(seen).hypotheses.front().weight, without, 0.01);
}

TEST_F(BarTracker, WhatIsForgottenDecidesNothing) {
  Tracker tracker =
      this->tracker({.temporal = TemporalModel::kGaussian, .neighbors = 5, .sigma_hog = 0.3});
  show(tracker, thin());
  tracker.forget();
  EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 2u);
}

TEST_F(BarTracker, AFrameWithoutAnAnswerSaysWhy) {
  Tracker strict = tracker({.max_distance = 0.01});
  EXPECT_EQ(show(strict, BarPicture{}).no_answer, NoAnswer::kNoHand);
  EXPECT_EQ(show(strict, bar(radians(30))).no_answer, NoAnswer::kUnlike);
  EXPECT_EQ(show(strict, bar(angle_of(1))).no_answer, NoAnswer::kNone);
}

TEST_F(BarTracker, SuccessorsAreWeighedThoughTheSearchMissesThem) {
  const OneRow search(*database_, 1);
  for (const TemporalModel model : {TemporalModel::kKde, TemporalModel::kSuccessors}) {
    const bool follows = model == TemporalModel::kSuccessors;
    Tracker tracker(*database_, search, testing::PlainOptions{.temporal = model, .sigma_hog = 0.3});
    show(tracker, bar(angle_of(1)));
    const Estimate estimate = show(tracker, bar(angle_of(2)));
    EXPECT_EQ(estimate.row, follows ? 2u : 1u);
    EXPECT_EQ(estimate.distance == 0, follows);
  }
}

TEST_F(BarTracker, NoMoreHypothesesAreRememberedThanAreKept) {
  std::size_t followed[2];
  for (const int kept : {1, 2}) {
    Tracker tracker = this->tracker({.temporal = TemporalModel::kSuccessors,
                                     .neighbors = 2,
                                     .kept = kept,
                                     .sigma_stretch = 1,
                                     .max_distance = 100});
    show(tracker, bar(radians(70)));  // between rows 3 and 4, which are of two poses
    followed[kept - 1] = show(tracker, bar(radians(70))).hypotheses.size();
  }
  EXPECT_LT(followed[0], followed[1]);
}

TEST_F(BarTracker, AFrameWithoutAHandIsInvalidAndForgetsThePast) {
  Tracker tracker =
      this->tracker({.temporal = TemporalModel::kGaussian, .neighbors = 5, .sigma_hog = 0.3});
  show(tracker, thin());
  EXPECT_FALSE(show(tracker, BarPicture{}).valid);
  EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 2u);
}

TEST_F(BarTracker, WhatLooksLikeNoRowIsInvalid) {
  Tracker tracker = this->tracker({.max_distance = 0.01});
  const Estimate estimate = show(tracker, bar(radians(30)));
  EXPECT_FALSE(estimate.valid);
  EXPECT_LT(estimate.confidence, show(tracker, bar(angle_of(1))).confidence);
  EXPECT_GT(estimate.box.width, 0);
}

TEST_F(BarTracker, ARowsOwnPictureIsAsFarAwayAsTheRowWas) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone});
  const Estimate estimate = show(tracker, bar(angle_of(1)));
  const Eigen::Vector3d palm =
      estimate.camera_from_hand * palm_center(testing::toy_skeleton(), estimate.angles);
  EXPECT_LT((palm - Eigen::Vector3d(0, 0, 0.7)).norm(), 1e-3);
}

TEST_F(BarTracker, WithReachTheHandIsMovedAndNothingElse) {
  Tracker still = tracker({.temporal = TemporalModel::kNone});
  Tracker moving = tracker({.temporal = TemporalModel::kNone, .reach = 0.33});
  const Estimate before = show(still, bar(angle_of(1))), after = show(moving, bar(angle_of(1)));
  EXPECT_EQ(after.row, before.row);
  EXPECT_EQ(after.camera_from_hand.rotation, before.camera_from_hand.rotation);
  EXPECT_EQ(after.angles, before.angles);
  const double moved =
      (after.camera_from_hand.translation - before.camera_from_hand.translation).norm();
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(moved, 0.2);
}

// The descriptor is stretched with its box: only the aspect ratio tells these apart.
TEST_F(BarTracker, ABoxOfAnotherShapeIsNoHand) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone, .neighbors = 1});
  BarPicture wide;
  for (int y = 43; y < 53; ++y) {
    for (int x = 4; x < 92; ++x) wide.mask.at(x, y) = wide.gray.at(x, y) = 255;
  }
  EXPECT_FALSE(show(tracker, wide).valid);
}

TEST_F(BarTracker, JointsProjectWhereTheySay) {
  Tracker tracker = this->tracker({});
  const Estimate estimate = show(tracker, bar(angle_of(1)));
  for (int i = 0; i < kKeypointCount; ++i) {
    EXPECT_LT((kCamera.project(estimate.joints.col(i)) - estimate.joints_px.col(i)).norm(), 1e-9);
  }
  EXPECT_EQ(estimate.joints.col(0), estimate.camera_from_hand.translation);
}

TEST_F(BarTracker, OptionsOutOfRangeAreRefusedByName) {
  for (const TrackerNumber& number : kTrackerNumbers) {
    for (const double value : {number.low - 1, number.high + 1, std::nan("")}) {
      TrackerOptions options = tuned_options(TemporalModel::kKde, DescriptorKind::kHog);
      if (std::isnan(value) && std::holds_alternative<int TrackerOptions::*>(number.member))
        continue;
      set_number(options, number, value);
      try {
        Tracker(*database_, *search_, options);
        ADD_FAILURE() << number.key << " = " << value;
      } catch (const Error& error) {
        EXPECT_EQ(error.fault().key, number.key);
      }
    }
  }
}

}  // namespace
}  // namespace graspdb
