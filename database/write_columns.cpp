// SPDX-License-Identifier: MIT
#include "write_columns.h"

#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"

namespace graspdb {
namespace {

std::string hash_of(ColumnIndex column, const ColumnSource& source) {
  Hasher hasher;
  source(column, [&](std::span<const std::byte> bytes) { hasher.add(bytes); });
  return hasher.hex();
}

}  // namespace

void write_columns(const std::filesystem::path& path, const DatabaseInfo& info, std::size_t rows,
                   const ColumnSource& source) {
  GRASPDB_CHECK(rows <= std::numeric_limits<std::uint32_t>::max());
  check_info(info, path.string());
  Header header{.info = info, .rows = rows, .column_hashes = {}};
  const std::size_t columns = columns_of(info).size();
  for (std::size_t column = 0; column < columns; ++column) {
    header.column_hashes.push_back(hash_of(static_cast<ColumnIndex>(column), source));
  }
  FileAside file(path);
  file.write(header_bytes(header, path.string()));
  for (std::size_t column = 0; column < columns; ++column) {
    source(static_cast<ColumnIndex>(column),
           [&](std::span<const std::byte> bytes) { file.write(bytes); });
  }
  file.commit();
}

}  // namespace graspdb
