// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "graspdb/core/error.h"
#include "write_columns.h"

namespace graspdb {
namespace {

static_assert(sizeof(BoxTangents) == 4 * sizeof(float), "a box is stored as four numbers");
static_assert(std::endian::native == std::endian::little, "columns are written as they lie");

const void* field(const Row& row, ColumnIndex column) {
  switch (column) {
    case kLabel:
      return row.label.data();
    case kBox:
      return &row.box;
    case kView:
      return &row.view;
    case kGrasp:
      return &row.grasp;
    case kHog:
      return row.hog.data();
    case kStep:
      return &row.step;
    case kHand:
      return &row.hand;
    case kEmbedding:
      return row.embedding.data();
    default:
      return &row.variant;
  }
}

std::vector<std::byte> packed(std::span<const Row> rows, ColumnIndex column, std::size_t size) {
  std::vector<std::byte> bytes(size * rows.size());
  std::byte* to = bytes.data();
  for (const Row& row : rows) {
    std::memcpy(to, field(row, column), size);
    to += size;
  }
  return bytes;
}

void check_row(const Row& row, const DatabaseInfo& info) {
  GRASPDB_CHECK(is_finite(row.label));
  const BoxTangents& box = row.box;
  GRASPDB_CHECK(std::isfinite(box.x + box.y) && std::isfinite(box.width + box.height));
  GRASPDB_CHECK(row.embedding.size() == info.embedding_bytes);
  GRASPDB_CHECK(row.step >= 1 && row.step <= info.steps);
  GRASPDB_CHECK(row.view < static_cast<std::uint32_t>(info.views));
  GRASPDB_CHECK(row.hand < info.hands.size() && row.variant < info.variants.size());
  GRASPDB_CHECK(std::ranges::count(info.grasps, row.grasp, &GraspEntry::id) == 1);
}

}  // namespace

void write_database(const std::filesystem::path& path, const DatabaseInfo& info,
                    std::span<const Row> rows) {
  check_info(info, path.string());
  for (const Row& row : rows) check_row(row, info);
  write_columns(path, info, rows.size(), [&](ColumnIndex column, const ByteSink& sink) {
    sink(packed(rows, column, columns_of(info)[column].row_bytes()));
  });
}

}  // namespace graspdb
