// SPDX-License-Identifier: MIT
#include "graspdb/pose_grid.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <tuple>

#include "graspdb/error.h"
#include "graspdb/pose_vector.h"

namespace graspdb {
namespace {

using Angles = std::array<float, kAngleCount>;

Angles angles_of(const Database& database, std::size_t row) {
  Angles angles;
  const auto label = database.label(row);
  std::copy(label.begin() + 3, label.end(), angles.begin());
  return angles;
}

[[noreturn]] void fail(const Database& database, std::size_t row, const char* expected) {
  throw Error({database.path().string(), fmt::format("row {}", row), expected, "another"});
}

void check_row(const Database& database, std::size_t row, std::size_t views) {
  const auto label = database.label(row), of_view = database.label(row % views);
  if (!std::equal(label.begin(), label.begin() + 3, of_view.begin()))
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
    views_.push_back(label_rotation(database.label(view)));
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
    const JointAngles angles = label_angles(database.label(row));
    poses_.push_back({angles, keypoints_in_palm(hands[hand].skeleton, angles), grasp});
  }
}

Pose PoseGrid::seen(std::size_t pose, std::size_t view, const Pose& truth) const {
  const Eigen::Matrix3d camera_from_hand = turn_to_palm(truth) * views_[view];
  const Keypoints& joints = poses_[pose].joints;
  const Eigen::Vector3d wrist = palm_centre(truth.joints) - camera_from_hand * palm_centre(joints);
  return {camera_from_hand, poses_[pose].angles, (camera_from_hand * joints).colwise() + wrist};
}

Eigen::Vector3d palm_centre(const Keypoints& joints) {
  return (joints.col(0) + joints.col(5) + joints.col(9) + joints.col(13) + joints.col(17)) / 5;
}

Eigen::Matrix3d turn_to_palm(const Pose& truth) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), palm_centre(truth.joints))
      .toRotationMatrix();
}

}  // namespace graspdb
