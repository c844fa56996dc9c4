// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace graspdb {

// What people should know about an input that could be read all the same, a sentence each.
struct Remarks {
  std::vector<std::string> notes;     // what was done to it: turned, scaled ...
  std::vector<std::string> warnings;  // what may make the answer wrong

  bool empty() const { return notes.empty() && warnings.empty(); }
};

}  // namespace graspdb
