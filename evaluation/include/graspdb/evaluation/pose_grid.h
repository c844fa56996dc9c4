// SPDX-License-Identifier: MIT
// A database seen as what it is, poses x views: a row is one pose of one hand seen from one view.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "graspdb/database/database.h"
#include "graspdb/evaluation/metrics.h"

namespace graspdb {

class PoseGrid {
 public:
  // Poses that several rows share (those of a hand with and without the object) are kept once.
  // Throws Error for a database without rows or one that is no such grid.
  explicit PoseGrid(const Database& database);

  struct HandPose {
    JointAngles angles;
    Keypoints joints;  // hand frame
    int grasp = 0;     // id
  };
  const std::vector<Eigen::Matrix3d>& views() const { return views_; }
  const std::vector<HandPose>& poses() const { return poses_; }

  std::size_t view_of(std::uint32_t row) const { return row % views_.size(); }
  std::size_t pose_of(std::uint32_t row) const { return pose_of_block_[row / views_.size()]; }
  std::size_t rows() const { return views_.size() * pose_of_block_.size(); }

  // This pose and view where the true palm is: the view turned from the camera's axis to the ray
  // to the palm centre, the palm centre there. Of a frame that looks like them once turned
  // clockwise by roll_deg.
  Pose seen(std::size_t pose, std::size_t view, const Pose& truth, double roll_deg = 0) const;

 private:
  std::vector<Eigen::Matrix3d> views_;  // camera_from_hand of a camera that looks at the palm
  std::vector<HandPose> poses_;
  std::vector<std::size_t> pose_of_block_;  // of `views_.size()` rows
};

// Turns the camera's axis to the ray to the true palm centre.
Eigen::Matrix3d turn_to_palm(const Pose& truth);

}  // namespace graspdb
