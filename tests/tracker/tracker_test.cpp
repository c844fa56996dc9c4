// SPDX-License-Identifier: MIT
#include "graspdb/tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "graspdb/error.h"
#include "graspdb/hog.h"
#include "mirror.h"
#include "support/temporary_directory.h"
#include "support/toy_skeleton.h"

namespace graspdb {
namespace {

constexpr int kSide = 96;
constexpr Intrinsics kCamera{.width = kSide,
                             .height = kSide,
                             .fx = 480,
                             .fy = 480,
                             .cx = (kSide - 1) / 2.0,
                             .cy = (kSide - 1) / 2.0};

struct Picture {
  GrayImage gray{kSide, kSide};
  Mask mask{kSide, kSide};
};

// A bright bar that lies at this angle to the picture's x axis.
Picture bar(double angle) {
  Picture picture;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = x - kSide / 2.0, v = y - kSide / 2.0;
      const double along = u * std::cos(angle) + v * std::sin(angle);
      const double across = -u * std::sin(angle) + v * std::cos(angle);
      if (std::abs(along) > 36 || std::abs(across) > 12) continue;
      picture.mask.at(x, y) = 255;
      picture.gray.at(x, y) = static_cast<std::uint8_t>(150 + 3 * across);
    }
  }
  return picture;
}

// Eight rows: bars turned by 20 degrees from row to row, the hand turned with them.
class BarTracker : public ::testing::Test {
 protected:
  static double angle_of(std::size_t row) { return radians(20.0 * static_cast<double>(row)); }

  BarTracker() {
    DatabaseInfo info{.grasps = {{1, "one"}, {2, "two"}},
                      .hands = {{"toy", testing::toy_skeleton()}},
                      .variants = {"free"},
                      .steps = 1,
                      .views = 4,
                      .camera_distance = 0.7,
                      .view_rule = "bars",
                      .hog = hog_name({}),
                      .config = "{}",
                      .tool = "test"};
    std::vector<Row> rows(8);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Picture picture = bar(angle_of(i));
      rows[i].hog = describe(picture.gray, picture.mask);
      rows[i].label[2] = static_cast<float>(angle_of(i));
      rows[i].box = {-0.075F, -0.075F, 0.15F, 0.15F};
      rows[i].grasp = i < 4 ? 1 : 2;
      rows[i].step = 1;
    }
    write_database(directory_ / "bars.graspdb", info, rows);
    database_.emplace(Database::open(directory_ / "bars.graspdb"));
    search_ = make_exact_search(*database_);
  }

  Tracker tracker(TrackerOptions options) { return {*database_, *search_, options}; }

  testing::TemporaryDirectory directory_;
  std::optional<Database> database_;
  std::unique_ptr<Search> search_;
};

Estimate show(Tracker& tracker, const Picture& picture) {
  return tracker.step({picture.gray, picture.mask, kCamera});
}

TEST_F(BarTracker, ARowsOwnPictureGivesThatRow) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone, .neighbours = 4});
  for (std::size_t row = 0; row < 8; ++row) {
    const Estimate estimate = show(tracker, bar(angle_of(row)));
    ASSERT_TRUE(estimate.valid);
    EXPECT_EQ(estimate.row, row);
    EXPECT_EQ(estimate.distance, 0);
    EXPECT_EQ(estimate.confidence, 1);
    EXPECT_EQ(estimate.grasp, row < 4 ? 1 : 2);
    EXPECT_LT(degrees(angle_between(estimate.camera_from_hand,
                                    rotation_from_vector({0, 0, angle_of(row)}))),
              1);
  }
}

TEST_F(BarTracker, WeightsSumToOneAndTheHeaviestIsFirst) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kKde, .neighbours = 6});
  for (int frame = 0; frame < 3; ++frame) {
    const Estimate estimate = show(tracker, bar(radians(25)));
    double sum = 0;
    for (std::size_t i = 0; i < estimate.hypotheses.size(); ++i) {
      sum += estimate.hypotheses[i].weight;
      if (i > 0) EXPECT_LE(estimate.hypotheses[i].weight, estimate.hypotheses[i - 1].weight);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(estimate.hypotheses.front().row, estimate.row);
    EXPECT_GT(estimate.grasp_probability, 0);
    EXPECT_LE(estimate.grasp_probability, 1 + 1e-12);
  }
}

// Between two rows the picture does not tell which; the past does.
TEST_F(BarTracker, ThePastDecidesWhatThePictureLeavesOpen) {
  for (const TemporalModel model : {TemporalModel::kGaussian, TemporalModel::kKde}) {
    for (const std::size_t before : {std::size_t{2}, std::size_t{3}}) {
      Tracker tracker = this->tracker({.temporal = model,
                                       .neighbours = 8,
                                       .sigma_hog = 3,
                                       .sigma_pose = 0.2,
                                       .bandwidth = 0.2});
      show(tracker, bar(angle_of(before)));
      EXPECT_EQ(show(tracker, bar(radians(50))).row, before);
    }
  }
}

TEST_F(BarTracker, AFrameWithoutAHandIsInvalidAndForgetsThePast) {
  const TrackerOptions options{
      .temporal = TemporalModel::kGaussian, .neighbours = 8, .sigma_hog = 3, .sigma_pose = 0.2};
  Tracker fresh = tracker(options), interrupted = tracker(options);
  show(interrupted, bar(angle_of(3)));
  EXPECT_FALSE(show(interrupted, Picture{}).valid);
  EXPECT_EQ(show(interrupted, bar(radians(50))).row, show(fresh, bar(radians(50))).row);
}

TEST_F(BarTracker, WhatLooksLikeNoRowIsInvalid) {
  Tracker tracker = this->tracker({.max_distance = 0.01});
  const Estimate estimate = show(tracker, bar(radians(30)));
  EXPECT_FALSE(estimate.valid);
  EXPECT_LT(estimate.confidence, 0.5);
  EXPECT_GT(estimate.box.width, 0);
}

TEST_F(BarTracker, JointsProjectWhereTheySay) {
  Tracker tracker = this->tracker({});
  const Estimate estimate = show(tracker, bar(angle_of(1)));
  for (int i = 0; i < kKeypointCount; ++i) {
    EXPECT_LT((kCamera.project(estimate.joints.col(i)) - estimate.joints_px.col(i)).norm(), 1e-9);
  }
  EXPECT_EQ(estimate.joints.col(0), estimate.wrist);
}

TEST_F(BarTracker, AMirroredPictureOfTheOtherHandGivesTheMirroredAnswer) {
  const Picture picture = bar(angle_of(1));
  Tracker right = this->tracker({}), left = this->tracker({.left_hand = true});
  const Estimate seen = show(right, picture);
  const GrayImage gray = mirrored(picture.gray);
  const Mask mask = mirrored(picture.mask);
  const Estimate other = left.step({gray, mask, kCamera});
  EXPECT_EQ(other.row, seen.row);
  EXPECT_NEAR(other.wrist.x(), -seen.wrist.x(), 1e-9);
  EXPECT_NEAR(other.wrist.z(), seen.wrist.z(), 1e-9);
  EXPECT_NEAR(other.camera_from_hand.determinant(), 1, 1e-9);
  for (int i = 0; i < kKeypointCount; ++i) {
    EXPECT_LT((kCamera.project(other.joints.col(i)) - other.joints_px.col(i)).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace graspdb
