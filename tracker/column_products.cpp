// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "column_products.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "column_products.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <array>

#include "graspdb/core/error.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kColumnBlock / 2>;

constexpr std::size_t kRows = 4, kVectors = 2;  // whose sums are in registers

// Some rows' products with as many columns as two vectors have lanes. Product and sum are rounded
// apart: who multiplies and adds in one step would get other bytes.
HWY_INLINE void BlockProducts(const float* HWY_RESTRICT rows, const float* HWY_RESTRICT columns,
                              std::size_t count, std::size_t line, float* HWY_RESTRICT products) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  std::array<std::array<hn::Vec<Floats>, kVectors>, kRows> sums;
  for (auto& of_row : sums) of_row.fill(hn::Zero(f));
  for (std::size_t k = 0; k < count; ++k, rows += line, columns += line) {
    const auto first = hn::LoadU(f, columns), second = hn::LoadU(f, columns + lanes);
    for (std::size_t row = 0; row < kRows; ++row) {
      const auto factor = hn::Set(f, rows[row]);
      sums[row][0] = hn::Add(sums[row][0], hn::Mul(factor, first));
      sums[row][1] = hn::Add(sums[row][1], hn::Mul(factor, second));
    }
  }
  for (std::size_t row = 0; row < kRows; ++row) {
    hn::StoreU(sums[row][0], f, products + row * line);
    hn::StoreU(sums[row][1], f, products + row * line + lanes);
  }
}

void ColumnProducts(std::span<const float> lines, std::size_t columns, std::span<float> products) {
  const std::size_t count = lines.size() / columns, step = kVectors * hn::Lanes(Floats());
  for (std::size_t row = 0; row < columns; row += kRows) {
    for (std::size_t column = 0; column < row + kRows; column += step) {
      BlockProducts(lines.data() + row, lines.data() + column, count, columns,
                    products.data() + row * columns + column);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(ColumnProducts);

void column_products(std::span<const float> lines, std::size_t columns, std::span<float> products) {
  GRASPDB_CHECK(columns > 0 && columns % kColumnBlock == 0 && lines.size() % columns == 0 &&
                products.size() == columns * columns);
  HWY_DYNAMIC_DISPATCH(ColumnProducts)(lines, columns, products);
}

}  // namespace graspdb
#endif
