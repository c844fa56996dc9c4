// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "code_distance.h"
#include "graspdb/database/search.h"
#include "huge_pages.h"
#include "top_k.h"

namespace graspdb {

// Short codes of whole numbers, -128..127, laid out so that all of them are compared quickly
// (code_distance.h). The first numbers of all codes lie by themselves: most rows are too far away
// by these alone, and the rest of them is never read.
class CodeTable {
 public:
  CodeTable(std::size_t rows, std::size_t dimensions);

  // Rows may be stored from several threads at once.
  void store(std::size_t row, std::span<const std::int8_t> code);

  // The `count` nearest codes of each query, nearest first, ties by row; the distances are those of
  // the codes. The table is read once, hardly ever twice.
  std::vector<std::vector<Neighbor>> nearest(const std::vector<std::vector<std::int8_t>>& queries,
                                             std::size_t count) const;

 private:
  // A part of a code, as a query.
  struct Query {
    explicit Query(std::span<const std::int8_t> code);
    std::vector<std::uint8_t> raised_numbers;
    std::int32_t norm;
  };

  struct Search {
    Query head, tail;
    TopK best;
  };

  // The same part of all codes.
  struct Part {
    Part(std::size_t rows, std::size_t dimensions);
    void store(std::size_t row, std::span<const std::int8_t> code);
    // As code_distances() for the rows from `start` on, the first one of a block.
    void distances(const Query& query, std::size_t start, std::int32_t bound,
                   std::span<std::int32_t> squared, std::span<bool> near) const;

    std::size_t length;  // of a code, rounded up to whole quads
    HugePages codes;     // whole batches of blocks
    std::vector<std::int32_t> row_terms;
  };

  // Some rows more than `wanted` are most probably nearer than this.
  std::uint32_t likely_bound(const Search& search, std::size_t wanted) const;
  void scan(std::span<Search> searches) const;
  void scan_batch(std::size_t start, Search& search) const;
  void offer_block(const Query& tail, std::size_t start, std::span<const std::int32_t> squared,
                   TopK& best) const;

  std::size_t rows_, dimensions_, head_dimensions_;
  Part head_, tail_;
};

}  // namespace graspdb
