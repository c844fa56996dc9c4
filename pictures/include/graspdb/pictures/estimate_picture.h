// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "graspdb/core/image.h"
#include "graspdb/database/database.h"
#include "graspdb/pictures/database_rows.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

// Draws what an estimate looks like: the hand of its row (and its object, when the row holds one),
// made again from the configuration that the database stores, in the estimated orientation. Not
// thread-safe; the database must outlive it.
class EstimatePicture {
 public:
  explicit EstimatePicture(const Database& database) : database_(database) {}

  // A square picture of a valid estimate, `side` pixels; of a left hand the mirror image of the
  // database's right one. A grasp's first one takes a second where
  // the hand has no committed closed pose. Throws Error when hand or grasp files are absent or are
  // not those that the database was built from.
  ColorImage draw(const Estimate& estimate, int side);
  // The same of a row as the database has it; in the mirror for a left hand. Throws Error alike.
  ColorImage draw_row(std::uint32_t row, bool left_hand, int side);

 private:
  ColorImage draw_turned(std::uint32_t row, const Eigen::Matrix3d& right_hand_rotation,
                         bool left_hand, int side);
  const DatabaseRows& rows_like(std::uint32_t row);
  static Eigen::Matrix3d right_hand_rotation(const Estimate& estimate);

  const Database& database_;
  std::map<int, DatabaseRows> rows_;  // by grasp
};

}  // namespace graspdb
