// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "graspdb/database/database.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {

// What a database's hands hold, as far as the grasp files tell that it was built from and that have
// not changed since.
class DatabaseObjects {
 public:
  explicit DatabaseObjects(const Database& database);

  // The sequence's object beside the one whose three sides are nearest to its own, e.g. "bottle
  // 50 x 50 x 190 mm; nearest in the database: pipe 31 x 31 x 208 mm, mean difference 19 mm".
  std::string beside(const SequenceSpec& sequence) const;

 private:
  struct Object {
    std::string name;
    Eigen::Vector3d sides_mm;  // of its box, shortest first
  };
  static Object object_of(const Grasp& grasp);

  std::vector<Object> objects_;
};

}  // namespace graspdb
