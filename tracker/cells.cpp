// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; see column_products.cpp.
#include "cells.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cells.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <cstdlib>

#include "graspdb/core/error.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Rows = hn::CappedTag<std::uint64_t, kSide>;
using RowsVec = hn::Vec<Rows>;

HWY_INLINE RowsVec MovedRight(RowsVec rows, int right) {
  return right >= 0 ? hn::ShiftLeftSame(rows, right) : hn::ShiftRightSame(rows, -right);
}

Overlap OverlapOf(const Cells& seen, const Cells& inside, const std::uint64_t* HWY_RESTRICT hand,
                  const std::uint64_t* HWY_RESTRICT arm, int right) {
  const Rows d;
  auto bare = hn::Zero(d), of_arm = hn::Zero(d), in_vain = hn::Zero(d);
  for (std::size_t y = 0; y < kSide; y += hn::Lanes(d)) {
    const auto seen_here = hn::LoadU(d, seen.data() + y);
    const auto hand_here = MovedRight(hn::LoadU(d, hand + y), right);
    const auto arm_here = MovedRight(hn::LoadU(d, arm + y), right);
    const auto uncovered = hn::AndNot(hand_here, seen_here);
    const auto beside = hn::AndNot(seen_here, hand_here);
    bare = hn::Add(bare, hn::PopulationCount(hn::AndNot(arm_here, uncovered)));
    of_arm = hn::Add(of_arm, hn::PopulationCount(hn::And(arm_here, uncovered)));
    const auto in_picture = hn::LoadU(d, inside.data() + y);
    in_vain = hn::Add(in_vain, hn::PopulationCount(hn::And(beside, in_picture)));
  }
  const auto total = [d](RowsVec counts) HWY_ATTR {
    return static_cast<int>(hn::GetLane(hn::SumOfLanes(d, counts)));
  };
  return {total(bare), total(of_arm), total(in_vain)};
}

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(OverlapOf);

MovableCells::MovableCells(const Cells& cells) {
  std::ranges::copy(cells, rows_.begin() + kSide);
}

Overlap overlap_of(const Cells& seen, const Cells& inside, const MovableCells& hand,
                   const MovableCells& arm, int right, int down) {
  GRASPDB_CHECK(std::max(std::abs(right), std::abs(down)) < kSide);
  return HWY_DYNAMIC_DISPATCH(OverlapOf)(seen, inside, hand.moved(down), arm.moved(down), right);
}

}  // namespace graspdb
#endif
