// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace graspdb {

// Codes of small integers, laid out for the scan: blocks of 16 rows, in each of them the first two
// numbers of all 16 rows, then the next two, and so on.
constexpr std::size_t kCodeBlock = 16;

// Two numbers of a query's code, the first in the low half, as the scan wants them.
constexpr std::int32_t code_pair(std::int8_t first, std::int8_t second) {
  return static_cast<std::int32_t>(static_cast<std::uint16_t>(first) |
                                   static_cast<std::uint32_t>(static_cast<std::uint16_t>(second))
                                       << 16);
}

// For all blocks of `squared` (16 numbers each): the squared distance of each row's code to the
// query's, and whether any of the block is less than `bound`. `query` holds the pairs of one code;
// query_norm and norms are squared lengths of codes.
void code_distances(std::span<const std::int32_t> query, std::int32_t query_norm,
                    const std::int8_t* codes, const std::int32_t* norms, std::int32_t bound,
                    std::span<std::int32_t> squared, std::span<bool> near);

}  // namespace graspdb
