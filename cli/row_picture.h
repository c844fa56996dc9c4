// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "graspdb/database.h"
#include "graspdb/grasp.h"
#include "graspdb/hand.h"
#include "graspdb/image.h"
#include "graspdb/tracker.h"

namespace graspdb::cli {

// Draws what an estimate looks like: the row's hand (and its object, when the row holds one) in the
// estimated orientation. Needs the hand and grasp files that the database was built from.
class RowPicture {
 public:
  // `left_hand`: the estimates are of left hands, mirror images of the database's right ones.
  RowPicture(const Database& database, bool left_hand);

  // A square picture; none when the row's hand or grasp is not among the project's data.
  std::optional<ColorImage> draw(const Estimate& estimate, int side);

 private:
  const Hand* hand_of(std::uint32_t row);
  const Grasp* grasp_of(int id) const;
  Eigen::Matrix3d right_hand_rotation(const Estimate& estimate) const;
  const GraspPose& closed_of(const Grasp& grasp, const Hand& hand);

  const Database& database_;
  bool left_hand_;
  std::vector<Grasp> grasps_;
  JointAngles rest_;
  std::map<std::string, std::optional<Hand>> hands_;
  std::map<std::pair<std::string, int>, GraspPose> closed_;
};

}  // namespace graspdb::cli
