// SPDX-License-Identifier: MIT
#include "graspdb/tracker.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
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
Picture bar(double angle, double half_length = 36, double half_breadth = 12) {
  Picture picture;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = x - kSide / 2.0, v = y - kSide / 2.0;
      const double along = u * std::cos(angle) + v * std::sin(angle);
      const double across = -u * std::sin(angle) + v * std::cos(angle);
      if (std::abs(along) > half_length || std::abs(across) > half_breadth) continue;
      picture.mask.at(x, y) = 255;
      picture.gray.at(x, y) = static_cast<std::uint8_t>(150 + 2 * across);
    }
  }
  return picture;
}

// Rows 0 to 7 are bars turned by 20 degrees from row to row, the hand turned with them. Row 8 looks
// as row 2 does but is turned the other way round; rows 9 and 10 look like nothing else and have
// the poses of rows 2 and 8.
class BarTracker : public ::testing::Test {
 protected:
  static constexpr std::size_t kBars = 8, kFlipped = 2;
  static double angle_of(std::size_t row) { return radians(20.0 * static_cast<double>(row)); }
  static Picture square() { return bar(0, 20, 20); }
  static Picture thin() { return bar(radians(90), 40, 5); }

  static Row row(const Picture& picture, double angle, int grasp) {
    Row row;
    row.hog = describe(picture.gray, picture.mask);
    row.label[2] = static_cast<float>(angle);
    const Box box = tight_box(picture.mask).value();
    row.box = {static_cast<float>((box.x - 0.5 - kCamera.cx) / kCamera.fx),
               static_cast<float>((box.y - 0.5 - kCamera.cy) / kCamera.fy),
               static_cast<float>(box.width / kCamera.fx),
               static_cast<float>(box.height / kCamera.fy)};
    row.grasp = static_cast<std::uint16_t>(grasp);
    row.step = 1;
    return row;
  }

  BarTracker() {
    const DatabaseInfo info{.grasps = {{1, "one"}, {2, "two"}},
                            .hands = {{"toy", testing::toy_skeleton()}},
                            .variants = {"free"},
                            .steps = 1,
                            .views = 4,
                            .camera_distance = 0.7,
                            .view_rule = "bars",
                            .hog = hog_name({}),
                            .config = "{}",
                            .tool = "test"};
    std::vector<Row> rows;
    for (std::size_t i = 0; i < kBars; ++i)
      rows.push_back(row(bar(angle_of(i)), angle_of(i), i < 4 ? 1 : 2));
    const double turned = angle_of(kFlipped) - kPi;
    rows.push_back(row(bar(angle_of(kFlipped)), turned, 2));
    rows.push_back(row(square(), angle_of(kFlipped), 1));
    rows.push_back(row(thin(), turned, 2));
    rows.push_back(row(bar(radians(70), 20, 6), turned, 2));  // makes the last pose whole
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
  for (std::size_t row = 0; row < kBars; ++row) {
    const Estimate estimate = show(tracker, bar(angle_of(row)));
    ASSERT_TRUE(estimate.valid);
    EXPECT_EQ(estimate.row, row);
    EXPECT_EQ(estimate.distance, 0);
    EXPECT_GT(estimate.confidence, 0.95);
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

// Front or back: the picture does not tell, the past does.
TEST_F(BarTracker, ThePastDecidesWhatThePictureLeavesOpen) {
  for (const TemporalModel model : {TemporalModel::kGaussian, TemporalModel::kKde}) {
    Tracker tracker = this->tracker({.temporal = model, .neighbours = 5, .sigma_hog = 0.3});
    show(tracker, thin());
    EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 8u);
    tracker.forget();
    show(tracker, square());
    EXPECT_EQ(show(tracker, bar(angle_of(kFlipped))).row, 2u);
  }
  Tracker blind = tracker({.temporal = TemporalModel::kNone, .neighbours = 5, .sigma_hog = 0.3});
  show(blind, thin());
  EXPECT_EQ(show(blind, bar(angle_of(kFlipped))).row, 2u);
}

// Knows one row only.
class OneRow : public Search {
 public:
  OneRow(const Database& database, std::uint32_t row) : database_(database), row_(row) {}
  std::vector<Neighbor> nearest(const Descriptor& query, int /*k*/) const override {
    return measure(database_, query, std::span(&row_, 1));
  }

 private:
  const Database& database_;
  std::uint32_t row_;
};

TEST_F(BarTracker, SuccessorsAreWeighedThoughTheSearchMissesThem) {
  const OneRow search(*database_, 1);
  for (const TemporalModel model : {TemporalModel::kKde, TemporalModel::kSuccessors}) {
    const bool follows = model == TemporalModel::kSuccessors;
    Tracker tracker(*database_, search, {.temporal = model, .sigma_hog = 0.3});
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
                                     .neighbours = 2,
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
      this->tracker({.temporal = TemporalModel::kGaussian, .neighbours = 5, .sigma_hog = 0.3});
  show(tracker, thin());
  EXPECT_FALSE(show(tracker, Picture{}).valid);
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
      estimate.wrist +
      estimate.camera_from_hand * palm_centre(testing::toy_skeleton(), estimate.angles);
  EXPECT_LT((palm - Eigen::Vector3d(0, 0, 0.7)).norm(), 1e-3);
}

// The descriptor is stretched with its box: only the aspect ratio tells these apart.
TEST_F(BarTracker, ABoxOfAnotherShapeIsNoHand) {
  Tracker tracker = this->tracker({.temporal = TemporalModel::kNone, .neighbours = 1});
  Picture wide;
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
