// SPDX-License-Identifier: MIT
#include "code_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "graspdb/core/error.h"
#include "graspdb/core/rounded_up.h"

namespace graspdb {
namespace {

constexpr std::size_t kBatch = 32;  // blocks scanned at once: they stay in a cache
constexpr std::size_t kBatchRows = kBatch * kCodeBlock;

std::int32_t squared_length(std::span<const std::int8_t> code) {
  return std::inner_product(code.begin(), code.end(), code.begin(), std::int32_t{0});
}

}  // namespace

CodeTable::CodeTable(std::size_t rows, std::size_t dimensions)
    : rows_(rows),
      dimensions_(dimensions),
      length_(rounded_up(dimensions, kCodeQuad)),
      codes_(rounded_up(rows, kBatchRows) * length_),
      row_terms_(rounded_up(rows, kBatchRows)) {}

void CodeTable::store(std::size_t row, std::span<const std::int8_t> code) {
  GRASPDB_CHECK(row < rows_ && code.size() == dimensions_);
  for (std::size_t i = 0; i < dimensions_; ++i) {
    codes_.bytes()[code_place(row, i, length_)] = static_cast<std::uint8_t>(code[i]);
  }
  row_terms_[row] = row_term(code);
}

std::vector<Neighbor> CodeTable::nearest(std::span<const std::int8_t> code,
                                         std::size_t count) const {
  GRASPDB_CHECK(code.size() == dimensions_);
  std::vector<std::uint8_t> query(length_);
  std::ranges::transform(code, query.begin(), raised);
  TopK best(std::min(count, rows_));
  for (std::size_t start = 0; start < rows_; start += kBatchRows) {
    scan_batch(query, squared_length(code), start, best);
  }
  return best.take();
}

void CodeTable::scan_batch(std::span<const std::uint8_t> query, std::int32_t query_norm,
                           std::size_t start, TopK& best) const {
  std::array<std::int32_t, kBatchRows> squared;
  std::array<bool, kBatch> near;
  // A row as near as the bound comes behind the one that set it, so that only nearer ones count.
  const std::uint32_t bound =
      std::min<std::uint32_t>(best.bound(), std::numeric_limits<std::int32_t>::max());
  const auto* codes = reinterpret_cast<const std::int8_t*>(codes_.bytes().data()) + start * length_;
  code_distances(query, query_norm, codes, row_terms_.data() + start,
                 static_cast<std::int32_t>(bound), squared, near);
  for (std::size_t block = 0; block < kBatch; ++block) {
    if (!near[block]) continue;
    for (std::size_t i = block * kCodeBlock; i < (block + 1) * kCodeBlock; ++i) {
      if (start + i >= rows_) return;  // the padding of the last batch
      best.offer(static_cast<std::uint32_t>(start + i), static_cast<std::uint32_t>(squared[i]));
    }
  }
}

}  // namespace graspdb
