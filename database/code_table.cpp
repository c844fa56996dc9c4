// SPDX-License-Identifier: MIT
#include "code_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "graspdb/core/error.h"
#include "graspdb/core/rounded_up.h"

namespace graspdb {
namespace {

constexpr std::size_t kHead = 64;         // numbers of a code that are compared first
constexpr std::size_t kBatchBlocks = 32;  // blocks scanned at once: they stay in a cache
constexpr std::size_t kBatchRows = kBatchBlocks * kCodeBlock;

// A bound for all rows is guessed from one block of so many, such that about this many times the
// wanted rows are nearer: less often finds too few, more costs time.
constexpr std::size_t kSampled = 32, kLeeway = 2;
constexpr std::size_t kFewest = 4;  // rows of the sample that a guess relies on

std::int32_t squared_length(std::span<const std::int8_t> code) {
  return std::inner_product(code.begin(), code.end(), code.begin(), std::int32_t{0});
}

// A row as near as the bound comes behind the one that set it, so that only nearer ones count.
std::int32_t bound_of(const TopK& best) {
  return static_cast<std::int32_t>(
      std::min<std::uint32_t>(best.bound(), std::numeric_limits<std::int32_t>::max()));
}

}  // namespace

CodeTable::Query::Query(std::span<const std::int8_t> code)
    : raised_numbers(rounded_up(code.size(), kCodeQuad)), norm(squared_length(code)) {
  std::ranges::transform(code, raised_numbers.begin(), raised);
}

CodeTable::Part::Part(std::size_t rows, std::size_t dimensions)
    : length(rounded_up(dimensions, kCodeQuad)),
      codes(rounded_up(rows, kBatchRows) * length),
      row_terms(rounded_up(rows, kBatchRows)) {}

void CodeTable::Part::store(std::size_t row, std::span<const std::int8_t> code) {
  for (std::size_t i = 0; i < code.size(); ++i) {
    codes.bytes()[code_place(row, i, length)] = static_cast<std::uint8_t>(code[i]);
  }
  row_terms[row] = row_term(code);
}

void CodeTable::Part::distances(const Query& query, std::size_t start, std::int32_t bound,
                                std::span<std::int32_t> squared, std::span<bool> near) const {
  const auto* first = reinterpret_cast<const std::int8_t*>(codes.bytes().data()) + start * length;
  code_distances(query.raised_numbers, query.norm, first, row_terms.data() + start, bound, squared,
                 near);
}

CodeTable::CodeTable(std::size_t rows, std::size_t dimensions)
    : rows_(rows),
      dimensions_(dimensions),
      head_dimensions_(std::min(kHead, dimensions)),
      head_(rows, head_dimensions_),
      tail_(rows, dimensions - head_dimensions_) {}

void CodeTable::store(std::size_t row, std::span<const std::int8_t> code) {
  GRASPDB_CHECK(row < rows_ && code.size() == dimensions_);
  head_.store(row, code.first(head_dimensions_));
  tail_.store(row, code.subspan(head_dimensions_));
}

std::vector<std::vector<Neighbor>> CodeTable::nearest(
    const std::vector<std::vector<std::int8_t>>& queries, std::size_t count) const {
  const std::size_t wanted = std::min(count, rows_);
  std::vector<Search> searches;
  for (const std::span<const std::int8_t> code : queries) {
    GRASPDB_CHECK(code.size() == dimensions_);
    Search search{Query(code.first(head_dimensions_)), Query(code.subspan(head_dimensions_)),
                  TopK(wanted)};
    search.best = TopK(wanted, likely_bound(search, wanted));
    searches.push_back(std::move(search));
  }
  scan(searches);
  std::vector<std::vector<Neighbor>> found;
  for (Search& search : searches) {
    if (!search.best.is_full()) {
      search.best = TopK(wanted);
      scan(std::span(&search, 1));
    }
    found.push_back(search.best.take());
  }
  return found;
}

// Most rows are then refused from the first one on.
std::uint32_t CodeTable::likely_bound(const Search& search, std::size_t wanted) const {
  TopK nearest(wanted * kLeeway / kSampled + kFewest);
  std::array<std::int32_t, kCodeBlock> squared;
  std::array<bool, 1> near;
  for (std::size_t start = 0; start < rows_; start += kSampled * kCodeBlock) {
    head_.distances(search.head, start, bound_of(nearest), squared, near);
    if (near.front()) offer_block(search.tail, start, squared, nearest);
  }
  return nearest.is_full() ? nearest.take().back().squared_distance + 1 : TopK::kNoBound;
}

void CodeTable::scan(std::span<Search> searches) const {
  for (std::size_t start = 0; start < rows_; start += kBatchRows) {
    for (Search& search : searches) scan_batch(start, search);
  }
}

void CodeTable::scan_batch(std::size_t start, Search& search) const {
  std::array<std::int32_t, kBatchRows> squared;
  std::array<bool, kBatchBlocks> near;
  head_.distances(search.head, start, bound_of(search.best), squared, near);
  for (std::size_t block = 0; block < kBatchBlocks; ++block) {
    const std::size_t first = block * kCodeBlock;
    if (near[block])
      offer_block(search.tail, start + first, std::span(squared).subspan(first, kCodeBlock),
                  search.best);
  }
}

// `squared` are the distances by the heads.
void CodeTable::offer_block(const Query& tail, std::size_t start,
                            std::span<const std::int32_t> squared, TopK& best) const {
  std::array<std::int32_t, kCodeBlock> rest{};
  std::array<bool, 1> near;
  if (tail_.length > 0)
    tail_.distances(tail, start, std::numeric_limits<std::int32_t>::max(), rest, near);
  const std::size_t end = std::min(start + kCodeBlock, rows_);  // the last batch is padded
  for (std::size_t row = start; row < end; ++row) {
    const std::int32_t distance = squared[row - start] + rest[row - start];
    best.offer(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(distance));
  }
}

}  // namespace graspdb
