// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <vector>

#include "graspdb/core/error.h"
#include "mapped_file.h"
#include "write_columns.h"

namespace graspdb {
namespace {

// A part's file, held open.
struct OpenPart {
  MappedFile file;
  Header header;
  std::uint8_t hand, variant;

  explicit OpenPart(const DatabasePart& part)
      : file(part.file),
        header(read_header(file.bytes(), part.file.string())),
        hand(part.hand),
        variant(part.variant) {}

  std::span<const std::byte> column(ColumnIndex column) const {
    const Columns columns = columns_of(header.info);
    const std::size_t begin = columns.offset(column, header.rows);
    const std::size_t end = columns.offset(column + 1, header.rows);
    return data_bytes(file.bytes()).subspan(begin, end - begin);
  }
};

bool same(const HandEntry& a, const HandEntry& b) {
  return a.name == b.name && skeleton_to_json(a.skeleton) == skeleton_to_json(b.skeleton);
}

bool knows(const DatabaseInfo& info, const GraspEntry& grasp) {
  return std::ranges::any_of(info.grasps, [&](const GraspEntry& entry) {
    return entry.id == grasp.id && entry.name == grasp.name;
  });
}

// Rows of other hands, grasps or options are refused, not mixed in.
void check_part(const DatabasePart& part, const DatabaseInfo& rows, const DatabaseInfo& whole) {
  const auto expect = [&](bool fits, const char* key, const std::string& expected,
                          const std::string& found) {
    if (!fits) throw Error({part.file.string(), key, expected, found});
  };
  const auto number = [](auto value) { return std::to_string(value); };
  GRASPDB_CHECK(part.hand < whole.hands.size() && part.variant < whole.variants.size());
  const HandEntry& hand = whole.hands[part.hand];
  const std::string& variant = whole.variants[part.variant];
  expect(rows.processor == whole.processor, "processor", whole.processor, rows.processor);
  expect(rows.hog == whole.hog, "hog", whole.hog, rows.hog);
  expect(rows.weights == whole.weights, "weights", whole.weights, rows.weights);
  expect(rows.view_rule == whole.view_rule, "view_rule", whole.view_rule, rows.view_rule);
  expect(rows.views == whole.views, "views", number(whole.views), number(rows.views));
  expect(rows.steps == whole.steps, "steps", number(whole.steps), number(rows.steps));
  expect(rows.camera_distance == whole.camera_distance, "camera_distance_m",
         number(whole.camera_distance), number(rows.camera_distance));
  expect(rows.hands.size() == 1 && same(rows.hands[0], hand), "hands", hand.name, "another hand");
  expect(rows.variants.size() == 1 && rows.variants[0] == variant, "variants", variant, "another");
  for (const GraspEntry& grasp : rows.grasps) {
    expect(knows(whole, grasp), "grasps", "grasps of the whole", grasp.name);
  }
}

// `value` for each of so many rows, in pieces.
void repeat(std::uint8_t value, std::size_t rows, const ByteSink& sink) {
  std::array<std::byte, 4096> piece;
  piece.fill(std::byte{value});
  for (std::size_t done = 0; done < rows; done += piece.size()) {
    sink(std::span(piece).first(std::min(piece.size(), rows - done)));
  }
}

}  // namespace

void join_databases(const std::filesystem::path& path, const DatabaseInfo& info,
                    std::span<const DatabasePart> parts, const std::function<void()>& heed) {
  std::vector<std::unique_ptr<OpenPart>> open;
  std::size_t rows = 0;
  for (const DatabasePart& part : parts) {
    open.push_back(std::make_unique<OpenPart>(part));
    check_part(part, open.back()->header.info, info);
    rows += open.back()->header.rows;
  }
  write_columns(path, info, rows, [&](ColumnIndex column, const ByteSink& sink) {
    for (const auto& part : open) {
      if (heed) heed();
      const std::size_t count = part->header.rows;
      if (column == kHand) {
        repeat(part->hand, count, sink);
      } else if (column == kVariant) {
        repeat(part->variant, count, sink);
      } else {
        sink(part->column(column));
      }
    }
  });
}

}  // namespace graspdb
