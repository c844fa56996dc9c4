// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace graspdb {

constexpr std::size_t kColumnBlock = 32;

// Of all pairs of columns the products, summed over the lines in their order: lines^T lines, of
// which no more than the lower triangle is worked out. `columns` is a multiple of kColumnBlock;
// `lines` lie one after the other, and `products` are columns x columns numbers, row by row, which
// are replaced. The same bytes with every instruction set.
void column_products(std::span<const float> lines, std::size_t columns, std::span<float> products);

}  // namespace graspdb
