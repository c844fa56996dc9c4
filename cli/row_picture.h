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
  explicit RowPicture(const Database& database);

  // A square picture; none when the row's hand or grasp is not among the project's data.
  std::optional<ColorImage> draw(const Estimate& estimate, int side);

 private:
  const Hand* hand_of(std::uint32_t row);
  const Grasp* grasp_of(int id) const;
  const GraspPose& closed_of(const Grasp& grasp, const Hand& hand);

  const Database& database_;
  std::vector<Grasp> grasps_;
  JointAngles rest_;
  std::map<std::string, std::optional<Hand>> hands_;
  std::map<std::pair<std::string, int>, GraspPose> closed_;
};

}  // namespace graspdb::cli
