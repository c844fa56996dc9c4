// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; see distance.cpp.
#include "code_distance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "code_distance.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "graspdb/core/error.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

void CodeDistances(std::span<const std::int32_t> query, std::int32_t query_norm,
                   const std::int8_t* codes, const std::int32_t* norms, std::int32_t bound,
                   std::span<std::int32_t> squared, std::span<bool> near) {
  for (std::size_t row = 0; row < squared.size(); ++row) {
    const std::int8_t* code =
        codes + row / kCodeBlock * kCodeBlock * 2 * query.size() + row % kCodeBlock * 2;
    std::int32_t dot = 0;
    for (const std::int32_t pair : query) {
      dot += code[0] * static_cast<std::int16_t>(pair) + code[1] * (pair >> 16);
      code += 2 * kCodeBlock;
    }
    squared[row] = query_norm + norms[row] - 2 * dot;
    bool& any = near[row / kCodeBlock];
    any = (row % kCodeBlock != 0 && any) || squared[row] < bound;
  }
}

#else

using Sums = hn::CappedTag<std::int32_t, kCodeBlock>;
using Shorts = hn::Repartition<std::int16_t, Sums>;
using Codes = hn::Rebind<std::int8_t, Shorts>;

// As many rows as a vector has lanes; true when one of them is nearer than bound.
HWY_INLINE bool RowDistances(std::span<const std::int32_t> query, std::int32_t query_norm,
                             const std::int8_t* HWY_RESTRICT codes,
                             const std::int32_t* HWY_RESTRICT norms, std::int32_t bound,
                             std::int32_t* HWY_RESTRICT squared) {
  const Sums sums;
  auto even = hn::Zero(sums), odd = hn::Zero(sums), more = hn::Zero(sums);
  const auto add = [&](std::size_t pair, decltype(even) sum) HWY_ATTR {
    const auto row = hn::PromoteTo(Shorts(), hn::LoadU(Codes(), codes + pair * 2 * kCodeBlock));
    const auto numbers = hn::BitCast(Shorts(), hn::Set(sums, query[pair]));
    return hn::ReorderWidenMulAccumulate(sums, row, numbers, sum, more);
  };
  for (std::size_t pair = 0; pair + 1 < query.size(); pair += 2) {
    even = add(pair, even);
    odd = add(pair + 1, odd);
  }
  if (query.size() % 2 == 1) even = add(query.size() - 1, even);
  const auto dot = hn::Add(hn::Add(even, odd), more);
  const auto length = hn::Add(hn::LoadU(sums, norms), hn::Set(sums, query_norm));
  const auto distance = hn::Sub(length, hn::Add(dot, dot));
  hn::StoreU(distance, sums, squared);
  return !hn::AllFalse(sums, hn::Lt(distance, hn::Set(sums, bound)));
}

void CodeDistances(std::span<const std::int32_t> query, std::int32_t query_norm,
                   const std::int8_t* codes, const std::int32_t* norms, std::int32_t bound,
                   std::span<std::int32_t> squared, std::span<bool> near) {
  for (std::size_t block = 0; block < near.size(); ++block) {
    near[block] = false;
    for (std::size_t row = 0; row < kCodeBlock; row += hn::Lanes(Sums())) {
      const std::size_t at = block * kCodeBlock + row;
      const std::int8_t* code = codes + block * kCodeBlock * 2 * query.size() + row * 2;
      near[block] |= RowDistances(query, query_norm, code, norms + at, bound, squared.data() + at);
    }
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(CodeDistances);

void code_distances(std::span<const std::int32_t> query, std::int32_t query_norm,
                    const std::int8_t* codes, const std::int32_t* norms, std::int32_t bound,
                    std::span<std::int32_t> squared, std::span<bool> near) {
  GRASPDB_CHECK(squared.size() == near.size() * kCodeBlock);
  HWY_DYNAMIC_DISPATCH(CodeDistances)(query, query_norm, codes, norms, bound, squared, near);
}

}  // namespace graspdb
#endif
