// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace graspdb {

constexpr int kSide = 64;  // of what is looked at, in cells

// A bit a cell, the lowest to the left: a whole row is compared at once.
using Cells = std::array<std::uint64_t, kSide>;

// With nothing above and below, so that it can be moved down or up.
class MovableCells {
 public:
  MovableCells() = default;
  explicit MovableCells(const Cells& cells);

  // Its rows, `down` lower; -kSide..kSide. What comes in from beyond is empty.
  const std::uint64_t* moved(int down) const { return rows_.data() + kSide - down; }

 private:
  std::array<std::uint64_t, 3 * std::size_t{kSide}> rows_{};
};

// Numbers of cells.
struct Overlap {
  int bare = 0;     // seen, but neither hand nor arm
  int of_arm = 0;   // seen, arm but no hand
  int in_vain = 0;  // hand that is not seen, inside the picture
};

// Of what is seen in the picture and a hand with its arm, moved less than kSide each way. The same
// with every instruction set.
Overlap overlap_of(const Cells& seen, const Cells& inside, const MovableCells& hand,
                   const MovableCells& arm, int right, int down);

}  // namespace graspdb
