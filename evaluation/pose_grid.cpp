// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/pose_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/hand/label.h"

namespace graspdb {
namespace {

using Angles = std::array<float, kAngleCount>;

Angles angles_of(const Database& database, std::size_t row) {
  Angles angles;
  std::ranges::copy(database.label(row).last<kAngleCount>(), angles.begin());
  return angles;
}

[[noreturn]] void fail(const Database& database, std::size_t row, const char* expected) {
  throw Error({database.path().string(), fmt::format("row {}", row), expected, "another"});
}

void check_row(const Database& database, std::size_t row, std::size_t views) {
  const auto label = database.label(row), of_view = database.label(row % views);
  if (!std::ranges::equal(label.first<3>(), of_view.first<3>()))
    fail(database, row, "the rotation of its view");
  const std::size_t block = row - row % views;
  if (database.hand(row) != database.hand(block) ||
      angles_of(database, row) != angles_of(database, block)) {
    fail(database, row, "the hand and the angles of its pose");
  }
}

}  // namespace

PoseGrid::PoseGrid(const Database& database) {
  const auto views = static_cast<std::size_t>(database.info().views);
  const auto& hands = database.info().hands;
  if (database.rows() == 0 || database.rows() % views != 0) {
    throw Error({database.path().string(), "rows", "a multiple of the views, and some",
                 std::to_string(database.rows())});
  }
  for (std::size_t row = 0; row < database.rows(); ++row) check_row(database, row, views);
  for (std::size_t view = 0; view < views; ++view) {
    views_.push_back(unpack_label(database.label(view)).rotation);
  }
  std::map<std::tuple<int, int, Angles>, std::size_t> known;
  for (std::size_t row = 0; row < database.rows(); row += views) {
    const std::size_t hand = database.hand(row);
    if (hand >= hands.size()) fail(database, row, "a hand of the header");
    const int grasp = database.grasp(row);
    const auto [place, is_new] =
        known.try_emplace({static_cast<int>(hand), grasp, angles_of(database, row)}, poses_.size());
    pose_of_block_.push_back(place->second);
    if (!is_new) continue;
    const JointAngles angles = unpack_label(database.label(row)).angles;
    poses_.push_back({angles, keypoints_in_hand(hands[hand].skeleton, angles), grasp});
  }
}

Pose PoseGrid::seen(std::size_t pose, std::size_t view, const Pose& truth, double roll_deg) const {
  const Eigen::Matrix3d rotation =
      turn_to_palm(truth) * axis_rotation(2, radians(-roll_deg)) * views_[view];
  const Keypoints& joints = poses_[pose].joints;
  const Eigen::Vector3d wrist = palm_center(truth.joints) - rotation * palm_center(joints);
  return {rotation, poses_[pose].angles, (rotation * joints).colwise() + wrist};
}

Eigen::Matrix3d turn_to_palm(const Pose& truth) {
  return rotation_between(Eigen::Vector3d::UnitZ(), palm_center(truth.joints)).toRotationMatrix();
}

}  // namespace graspdb
