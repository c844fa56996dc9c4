// SPDX-License-Identifier: MIT
// The rows of a database as pictures, made again from the configuration that is stored in it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "graspdb/database/database.h"
#include "graspdb/pictures/labelled_view.h"

namespace graspdb {

// Thread-safe. The database must outlive it.
class DatabaseRows {
 public:
  // Loads the grasps of these rows and the database's hands. `resolution` replaces the one that the
  // rows were rendered at, pixels a side, 16..1024. Throws Error when the hand or grasp files are
  // absent or are not those that the database was built from.
  DatabaseRows(const Database& database, std::span<const std::size_t> rows,
               std::optional<int> resolution = {});

  PoseKey key(std::size_t row) const;

  // What the row shows, and all other rows with its key. Throws Error when the joint angles are not
  // those of the row's label.
  RowPose pose(std::size_t row) const;
  // The same, to be labelled.
  Subject subject(std::size_t row) const;

  // The row itself. `subject` is that of its key. Throws Error when the view is not the label's.
  LabelledView view(const Subject& subject, std::size_t row, const Layers& layers) const;

  const Grasp& grasp(std::size_t row) const;
  int resolution() const { return poses_.config().resolution; }

 private:
  const Database& database_;
  RowPoses poses_;
};

}  // namespace graspdb
