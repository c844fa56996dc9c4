// SPDX-License-Identifier: MIT
// Query-directed probing (Lv, Josephson, Wang, Charikar, Li 2007): the cells around the query's
// own, those first whose walls are near the query.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace graspdb {

// One step to a neighbouring cell: function +1 or -1.
struct Step {
  float score = 0;  // the squared distance to that wall, in cells
  std::uint8_t function = 0;
  std::int8_t direction = 0;
};

// Gives the sets of steps in the order of their scores' sums; the first is the empty set. No set
// steps twice along one function. At most 32 functions.
class ProbeSequence {
 public:
  // The query's coordinates in cells, of one table.
  explicit ProbeSequence(std::span<const float> projected);

  // The next set: bit i stands for steps()[i]. False when there is none left.
  bool next(std::uint64_t& set);
  const std::vector<Step>& steps() const { return steps_; }

 private:
  struct Candidate {
    float score;
    int last;  // the highest bit of the set
    std::uint64_t set;
  };
  static bool later(const Candidate& a, const Candidate& b);
  void push(const Candidate& candidate);
  bool valid(std::uint64_t set) const;

  std::vector<Step> steps_;               // by score
  std::vector<std::uint64_t> opposites_;  // bit of the step the other way
  std::vector<Candidate> heap_;
  bool started_ = false;
};

}  // namespace graspdb
