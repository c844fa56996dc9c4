// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "header.h"
#include "mapped_file.h"

namespace graspdb {
namespace {

void verify_columns(const std::filesystem::path& path) {
  const MappedFile file(path);
  const Header header = read_header(file.bytes(), path.string());
  const Columns columns = columns_of(header.info);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t offset = columns.offset(i, header.rows);
    const std::size_t size = columns.offset(i + 1, header.rows) - offset;
    const std::string found = hash_hex(data_bytes(file.bytes()).subspan(offset, size));
    if (found == header.column_hashes[i]) continue;
    throw Error({.file = path.string(),
                 .key = std::string(columns[i].name),
                 .expected = "checksum " + header.column_hashes[i],
                 .found = found});
  }
}

// Refuses values that no reader could look up, also when their checksum is right.
class RowVerifier {
 public:
  explicit RowVerifier(const Database& database) : database_(database) {}

  void verify(std::size_t row) const {
    const DatabaseInfo& info = database_.info();
    for (const float value : database_.label(row)) {
      if (!std::isfinite(value)) refuse(kLabel, row, "finite numbers", fmt::format("{}", value));
    }
    const BoxTangents box = database_.box(row);
    for (const float value : {box.x, box.y, box.width, box.height}) {
      if (!std::isfinite(value)) refuse(kBox, row, "finite numbers", fmt::format("{}", value));
    }
    expect(kView, row, 0, static_cast<std::size_t>(info.views), database_.view(row));
    expect(kStep, row, 1, static_cast<std::size_t>(info.steps) + 1, database_.step(row));
    expect(kHand, row, 0, info.hands.size(), database_.hand(row));
    expect(kVariant, row, 0, info.variants.size(), database_.variant(row));
    const std::uint16_t grasp = database_.grasp(row);
    if (std::ranges::count(info.grasps, grasp, &GraspEntry::id) == 0) {
      refuse(kGrasp, row, "the id of a grasp in the header", fmt::format("{}", grasp));
    }
  }

 private:
  void expect(ColumnIndex column, std::size_t row, std::size_t low, std::size_t end,
              std::size_t found) const {
    if (found >= low && found < end) return;
    refuse(column, row, fmt::format("at least {} and less than {}", low, end),
           fmt::format("{}", found));
  }
  [[noreturn]] void refuse(ColumnIndex column, std::size_t row, const std::string& expected,
                           const std::string& found) const {
    throw Error({.file = database_.path().string(),
                 .key = fmt::format("{}[{}]", columns_of(database_.info())[column].name, row),
                 .expected = expected,
                 .found = found});
  }

  const Database& database_;
};

}  // namespace

void verify_database(const std::filesystem::path& path) {
  verify_columns(path);
  const Database database = Database::open(path);
  const RowVerifier verifier(database);
  for (std::size_t row = 0; row < database.rows(); ++row) verifier.verify(row);
}

}  // namespace graspdb
