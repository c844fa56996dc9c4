// SPDX-License-Identifier: MIT
// The tracker on a database of learned codes.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <memory>
#include <optional>

#include "features/net_bytes.h"
#include "graspdb/core/file.h"
#include "graspdb/features/embedding.h"
#include "graspdb/hand/label.h"
#include "graspdb/tracker/hand_reader.h"
#include "tracker/bars.h"
#include "tracker/plain_options.h"

namespace graspdb {
namespace {

using testing::bar;
using testing::BarPicture;
using testing::kCamera;
using testing::PlainOptions;

// All is seen as the same bar, whose code is known. Codes and boxes of rows are linear in the angle
// by which the hand is turned.
class CodeTracker : public ::testing::Test {
 protected:
  CodeTracker() {
    write_text(directory_ / "toy.safetensors", testing::small_net(1).bytes());
    const EmbeddingNet net = EmbeddingNet::load(directory_ / "toy.safetensors");
    weights_ = net.hash();
    seen_code_ = net.describe(picture_.gray, picture_.mask).value();
  }

  Row row(double turn_deg, double byte_per_deg) const {
    Row row;
    row.label[2] = static_cast<float>(radians(turn_deg));
    const Box box = tight_box(picture_.mask).value();
    row.box = {static_cast<float>((box.x - 0.5 - kCamera.cx) / kCamera.fx + 0.002 * turn_deg),
               static_cast<float>((box.y - 0.5 - kCamera.cy) / kCamera.fy),
               static_cast<float>(box.width / kCamera.fx),
               static_cast<float>(box.height / kCamera.fy)};
    for (std::size_t i = 0; i < seen_code_.size(); ++i) {
      const double slope = seen_code_[i] < 128 ? byte_per_deg : -byte_per_deg;
      row.embedding.push_back(
          static_cast<std::uint8_t>(std::clamp(seen_code_[i] + slope * turn_deg, 0.0, 255.0)));
    }
    row.grasp = 1;
    row.step = 1;
    return row;
  }

  void write(const std::vector<double>& turns_deg, double byte_per_deg = 1) {
    std::vector<Row> rows;
    for (const double turn : turns_deg) {
      rows.push_back(row(turn, byte_per_deg));
      rows.back().view = static_cast<std::uint32_t>(rows.size() - 1);
    }
    const DatabaseInfo info{.grasps = {{1, "one"}},
                            .hands = {{"toy", testing::toy_skeleton()}},
                            .variants = {"free"},
                            .steps = 1,
                            .views = static_cast<int>(rows.size()),
                            .camera_distance = 0.7,
                            .view_rule = "turns",
                            .hog = hog_name(HogMode::kPaper),
                            .embedding_bytes = seen_code_.size(),
                            .descriptor = "toy",
                            .weights = weights_,
                            .config = "{}",
                            .tool = "test"};
    write_database(directory_ / "codes.graspdb", info, rows);
    database_.emplace(Database::open(directory_ / "codes.graspdb"));
    search_ = make_exact_search(*database_);
    describer_ = std::make_shared<Describer>(*database_, directory_ / "toy.safetensors");
  }

  Estimate answer(const TrackerOptions& options) const {
    Tracker tracker(*database_, *search_, options, describer_);
    return tracker.step({picture_.gray, picture_.mask, kCamera});
  }

  testing::TemporaryDirectory directory_;
  BarPicture picture_ = bar(0);
  std::string weights_;
  Embedding seen_code_;
  std::optional<Database> database_;
  std::unique_ptr<Search> search_;
  std::shared_ptr<const Describer> describer_;
};

double turn_deg(const Estimate& estimate) {
  return degrees(angle_between(estimate.camera_from_hand.rotation, Eigen::Matrix3d::Identity()));
}

// The rows lie to one side of it but for one: their mean is far from it.
TEST_F(CodeTracker, MergedAnswersFollowTheLineOfPosesOverCodes) {
  write({-36, -33, -30, -27, -24, -21, -18, -15, -12, 9});
  for (const TemporalModel model : {TemporalModel::kNone, TemporalModel::kGaussian}) {
    PlainOptions options{.temporal = model, .sigma_hog = 2, .sigma_stretch = 10};
    EXPECT_NEAR(turn_deg(answer(options)), 9, 0.1);  // the nearest row
    options.merge_deg = 60;
    const Estimate merged = answer(options);
    EXPECT_LT(turn_deg(merged), 0.5);
    // Rows show their hands beside the middle of the box by what they are turned.
    const Eigen::Vector3d palm = palm_center(merged.joints);
    EXPECT_NEAR(palm.x() / palm.z(), 0.5 / kCamera.fx, 0.001);
  }
}

TEST_F(CodeTracker, WhatIsVeryNearToARowIsNotUnlikeAHand) {
  const auto unlikeness = [&] {
    return unlikeness_to(*database_, *search_, Handedness::kRight, describer_)(picture_.gray,
                                                                               picture_.mask);
  };
  write({1}, 7);  // in 64 bytes
  EXPECT_EQ(unlikeness(), 0);
  write({1}, 9);
  EXPECT_NEAR(unlikeness(), 9 * 8 / 255.0, 1e-6);
}

TEST_F(CodeTracker, OptionsAndConfidenceAreThoseOfCodes) {
  write({1}, 12);  // in 64 bytes
  EXPECT_EQ(descriptor_kind(*database_), DescriptorKind::kLearned);
  const TrackerOptions tuned = tuned_options(TemporalModel::kKde, DescriptorKind::kLearned);
  const Estimate estimate = answer(tuned);
  EXPECT_NEAR(estimate.distance, 12 * 8 / 255.0, 1e-6);
  EXPECT_NEAR(estimate.confidence, 0.5, 0.05);
  EXPECT_TRUE(estimate.valid);

  write({1}, 22);  // further than any hand of the training sequences, not than HOGs are
  HandReader reader(*database_, *search_, {}, describer_);
  EXPECT_FALSE(reader.read({picture_.gray, picture_.mask, kCamera}).valid);
}

}  // namespace
}  // namespace graspdb
