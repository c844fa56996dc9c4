// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "graspdb/core/error.h"
#include "graspdb/database/database.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct DiffArguments {
  std::string a, b;
};

// Prints what differs, and remembers whether anything does.
class Difference {
 public:
  void field(const char* name, const auto& a, const auto& b) {
    if (a == b) return;
    fmt::print("{}: {} | {}\n", name, a, b);
    different_ = true;
  }

  // `same(row)` for the rows that both have.
  void column(const char* name, std::size_t rows, const auto& same) {
    std::size_t count = 0, first = 0;
    for (std::size_t row = rows; row-- > 0;) {
      if (same(row)) continue;
      ++count;
      first = row;
    }
    if (count == 0) return;
    fmt::print("{}: {} of {} rows, the first is {}\n", name, count, rows, first);
    different_ = true;
  }

  bool any() const { return different_; }

 private:
  bool different_ = false;
};

std::string names(const DatabaseInfo& info) {
  std::string text;
  for (const GraspEntry& grasp : info.grasps) text += fmt::format("{} {}, ", grasp.id, grasp.name);
  for (const HandEntry& hand : info.hands) {
    text += hand.name + " " + skeleton_to_json(hand.skeleton) + ", ";
  }
  return text;
}

void compare_info(const DatabaseInfo& a, const DatabaseInfo& b, Difference& difference) {
  difference.field("steps", a.steps, b.steps);
  difference.field("views", a.views, b.views);
  difference.field("view rule", a.view_rule, b.view_rule);
  difference.field("hog", a.hog, b.hog);
  difference.field("camera distance, m", a.camera_distance, b.camera_distance);
  difference.field("variants", fmt::format("{}", fmt::join(a.variants, ", ")),
                   fmt::format("{}", fmt::join(b.variants, ", ")));
  difference.field("grasps and hands", names(a), names(b));
  difference.field("configuration", a.config, b.config);
  difference.field("tool", a.tool, b.tool);
  difference.field("data card", a.data_card, b.data_card);
  difference.field("processor", a.processor, b.processor);
}

void compare_rows(const Database& a, const Database& b, Difference& difference) {
  difference.field("rows", a.rows(), b.rows());
  const std::size_t rows = std::min(a.rows(), b.rows());
  const auto column = [&](const char* name, const auto& value) {
    difference.column(name, rows, [&](std::size_t row) { return value(a, row) == value(b, row); });
  };
  difference.column("label", rows, [&](std::size_t row) {
    return std::ranges::equal(a.label(row), b.label(row));
  });
  difference.column("hog", rows,
                    [&](std::size_t row) { return std::ranges::equal(a.hog(row), b.hog(row)); });
  column("box", [](const Database& d, std::size_t row) {
    const BoxTangents box = d.box(row);
    return std::array{box.x, box.y, box.width, box.height};
  });
  column("view", [](const Database& d, std::size_t row) { return d.view(row); });
  column("grasp", [](const Database& d, std::size_t row) { return d.grasp(row); });
  column("step", [](const Database& d, std::size_t row) { return d.step(row); });
  column("hand", [](const Database& d, std::size_t row) { return d.hand(row); });
  column("variant", [](const Database& d, std::size_t row) { return d.variant(row); });
}

void run(const DiffArguments& options) {
  const Database a = Database::open(options.a), b = Database::open(options.b);
  Difference difference;
  compare_info(a.info(), b.info(), difference);
  compare_rows(a, b, difference);
  if (difference.any()) throw Error(fmt::format("{} and {} differ", options.a, options.b));
  fmt::print("the same: {} rows, content {}\n", a.rows(), a.content_hash());
}

}  // namespace

void add_diff(CLI::App& app) {
  auto options = std::make_shared<DiffArguments>();
  CLI::App* verb =
      app.add_subcommand("diff", "Tell what differs between two databases; exit 1 when any does");
  verb->add_option("A", options->a, "A database")->required();
  verb->add_option("B", options->b, "Another")->required();
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
