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
// (code_distance.h).
class CodeTable {
 public:
  CodeTable(std::size_t rows, std::size_t dimensions);

  // Rows may be stored from several threads at once.
  void store(std::size_t row, std::span<const std::int8_t> code);

  // The `count` nearest codes, nearest first, ties by row; the distances are those of the codes.
  std::vector<Neighbor> nearest(std::span<const std::int8_t> code, std::size_t count) const;

 private:
  void scan_batch(std::span<const std::uint8_t> query, std::int32_t query_norm, std::size_t start,
                  TopK& best) const;

  std::size_t rows_, dimensions_;
  std::size_t length_;  // of a code, rounded up to whole quads
  HugePages codes_;     // whole batches of blocks
  std::vector<std::int32_t> row_terms_;
};

}  // namespace graspdb
