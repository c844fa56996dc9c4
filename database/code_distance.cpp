// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; see distance.cpp.
#include "code_distance.h"

#define HWY_WANT_AVX3_DL

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "code_distance.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include "graspdb/core/error.h"
#include "graspdb/core/highway/byte_quads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {

#if !GRASPDB_HAS_BYTE_QUADS

void CodeDistances(std::span<const std::uint8_t> query, std::int32_t query_norm,
                   const std::int8_t* codes, const std::int32_t* row_terms, std::int32_t bound,
                   std::span<std::int32_t> squared, std::span<bool> near) {
  for (std::size_t row = 0; row < squared.size(); ++row) {
    std::int32_t dot = 0;
    for (std::size_t i = 0; i < query.size(); ++i) {
      dot += query[i] * codes[code_place(row, i, query.size())];
    }
    squared[row] = query_norm + row_terms[row] - 2 * dot;
    bool& any = near[row / kCodeBlock];
    any = (row % kCodeBlock != 0 && any) || squared[row] < bound;
  }
}

#else

namespace hn = hwy::HWY_NAMESPACE;
static_assert(kCodeBlock % kByteQuadLanes == 0 && kCodeQuad == 4);

// As many rows as a vector has lanes; true when one of them is nearer than bound.
HWY_INLINE bool RowDistances(std::span<const std::uint8_t> query, std::int32_t query_norm,
                             const std::int8_t* HWY_RESTRICT codes,
                             const std::int32_t* HWY_RESTRICT row_terms, std::int32_t bound,
                             std::int32_t* HWY_RESTRICT squared) {
  const QuadSums sums;
  auto even = hn::Zero(sums), odd = hn::Zero(sums);
  const auto add = [&](std::size_t i, QuadSumsVec sum) HWY_ATTR {
    return AddProducts(sum, QuadAt(query.data() + i), LoadSignedQuads(codes + i * kCodeBlock));
  };
  std::size_t i = 0;
  for (; i + 2 * kCodeQuad <= query.size(); i += 2 * kCodeQuad) {
    even = add(i, even);
    odd = add(i + kCodeQuad, odd);
  }
  if (i < query.size()) even = add(i, even);
  const auto dot = hn::Add(even, odd);
  const auto length = hn::Add(hn::LoadU(sums, row_terms), hn::Set(sums, query_norm));
  const auto distance = hn::Sub(length, hn::Add(dot, dot));
  hn::StoreU(distance, sums, squared);
  return !hn::AllFalse(sums, hn::Lt(distance, hn::Set(sums, bound)));
}

void CodeDistances(std::span<const std::uint8_t> query, std::int32_t query_norm,
                   const std::int8_t* codes, const std::int32_t* row_terms, std::int32_t bound,
                   std::span<std::int32_t> squared, std::span<bool> near) {
  for (std::size_t block = 0; block < near.size(); ++block) {
    near[block] = false;
    for (std::size_t row = 0; row < kCodeBlock; row += hn::Lanes(QuadSums())) {
      const std::size_t at = block * kCodeBlock + row;
      const std::int8_t* code = codes + code_place(at, 0, query.size());
      near[block] |=
          RowDistances(query, query_norm, code, row_terms + at, bound, squared.data() + at);
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

// The squared length, and what raising the query adds to twice the products: 2 * 128 * row.
std::int32_t row_term(std::span<const std::int8_t> code) {
  std::int32_t norm = 0;
  for (const std::int8_t number : code) norm += number * (number + 256);
  return norm;
}

void code_distances(std::span<const std::uint8_t> query, std::int32_t query_norm,
                    const std::int8_t* codes, const std::int32_t* row_terms, std::int32_t bound,
                    std::span<std::int32_t> squared, std::span<bool> near) {
  GRASPDB_CHECK(squared.size() == near.size() * kCodeBlock && query.size() % kCodeQuad == 0);
  HWY_DYNAMIC_DISPATCH(CodeDistances)
  (query, query_norm, codes, row_terms, bound, squared, near);
}

}  // namespace graspdb
#endif
