// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace graspdb {

// Codes of small integers, laid out for the scan: blocks of 16 rows, in each of them the first four
// numbers of all 16 rows, then the next four, and so on. Lengths are multiples of four.
constexpr std::size_t kCodeBlock = 16;
constexpr std::size_t kCodeQuad = 4;

// Where number `i` of a row's code lies, when codes are `length` long.
constexpr std::size_t code_place(std::size_t row, std::size_t i, std::size_t length) {
  const std::size_t block = row / kCodeBlock * kCodeBlock * length;
  const std::size_t quad = i / kCodeQuad * kCodeQuad * kCodeBlock;
  return block + quad + row % kCodeBlock * kCodeQuad + i % kCodeQuad;
}

// A query's numbers, as the scan multiplies them: from 0 to 255.
constexpr std::uint8_t raised(std::int8_t number) {
  return static_cast<std::uint8_t>(number + 128);
}

// With it |query - row|^2 = |query|^2 + row_term(row) - 2 * sum of raised(query) * row.
std::int32_t row_term(std::span<const std::int8_t> code);

// For all blocks of `squared` (16 numbers each): the squared distance of each row's code to the
// query's, and whether any of the block is less than `bound`. `query` holds the numbers of one
// code, raised; query_norm is the squared length of the code itself.
void code_distances(std::span<const std::uint8_t> query, std::int32_t query_norm,
                    const std::int8_t* codes, const std::int32_t* row_terms, std::int32_t bound,
                    std::span<std::int32_t> squared, std::span<bool> near);

}  // namespace graspdb
