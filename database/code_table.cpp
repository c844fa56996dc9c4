// SPDX-License-Identifier: MIT
#include "code_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr std::size_t kBatch = 32;  // blocks scanned at once: they stay in a cache
constexpr std::size_t kBatchRows = kBatch * kCodeBlock;

std::int32_t squared_length(std::span<const std::int8_t> code) {
  return std::inner_product(code.begin(), code.end(), code.begin(), std::int32_t{0});
}

}  // namespace

CodeTable::CodeTable(std::size_t rows, std::size_t dimensions)
    : rows_(rows), dimensions_(dimensions) {
  GRASPDB_CHECK(dimensions % 2 == 0);
  const std::size_t padded = (rows + kBatchRows - 1) / kBatchRows * kBatchRows;
  codes_.resize(padded * dimensions);
  norms_.resize(padded);
}

void CodeTable::store(std::size_t row, std::span<const std::int8_t> code) {
  GRASPDB_CHECK(row < rows_ && code.size() == dimensions_);
  const std::size_t block = row / kCodeBlock * kCodeBlock * dimensions_;
  for (std::size_t i = 0; i < dimensions_; ++i) {
    codes_[block + i / 2 * 2 * kCodeBlock + row % kCodeBlock * 2 + i % 2] = code[i];
  }
  norms_[row] = squared_length(code);
}

std::vector<Neighbor> CodeTable::nearest(std::span<const std::int8_t> code,
                                         std::size_t count) const {
  GRASPDB_CHECK(code.size() == dimensions_);
  std::vector<std::int32_t> pairs;
  for (std::size_t i = 0; i < code.size(); i += 2) pairs.push_back(code_pair(code[i], code[i + 1]));
  TopK best(std::min(count, rows_));
  for (std::size_t start = 0; start < rows_; start += kBatchRows) {
    scan_batch(pairs, squared_length(code), start, best);
  }
  return best.take();
}

void CodeTable::scan_batch(std::span<const std::int32_t> query, std::int32_t query_norm,
                           std::size_t start, TopK& best) const {
  std::array<std::int32_t, kBatchRows> squared;
  std::array<bool, kBatch> near;
  // A row as near as the bound comes behind the one that set it, so that only nearer ones count.
  const std::uint32_t bound =
      std::min<std::uint32_t>(best.bound(), std::numeric_limits<std::int32_t>::max());
  code_distances(query, query_norm, codes_.data() + start * dimensions_, norms_.data() + start,
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
