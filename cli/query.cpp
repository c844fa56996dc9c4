// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "console.h"
#include "frame_source.h"
#include "graspdb/error.h"
#include "graspdb/hog.h"
#include "graspdb/image_io.h"
#include "graspdb/segmentation.h"
#include "row_sheet.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct Options {
  std::string database, image, mask, search = "exact", out;
  int count = 20;
  bool json = false;
};

struct Query {
  ColorImage picture;
  Mask hand;
  Box box;
};

// As `graspdb track` finds the hand in a frame.
Query read_query(const Options& options) {
  Query query{.picture = read_color(options.image)};
  query.hand = options.mask.empty() ? find_hand(query.picture)
                                    : isolate_hand(read_mask(options.mask, query.picture));
  const auto box = tight_box(query.hand);
  if (!box) throw Error({.file = options.image, .expected = "a hand", .found = "none"});
  query.box = *box;
  return query;
}

// The square around the hand; what is not hand is pale.
ColorImage hand_picture(const Query& query) {
  const Box& box = query.box;
  const int side = std::max(box.width, box.height) * 11 / 10;
  const int left = box.x + (box.width - side) / 2, top = box.y + (box.height - side) / 2;
  ColorImage square(side, side, {250, 250, 250});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int u = left + x, v = top + y;
      if (u < 0 || v < 0 || u >= query.hand.width() || v >= query.hand.height()) continue;
      Bgr& pixel = square.at(x, y) = query.picture.at(u, v);
      if (query.hand.at(u, v) != 0) continue;
      for (std::uint8_t& channel : pixel) channel = static_cast<std::uint8_t>(190 + channel / 4);
    }
  }
  return square;
}

// A row's 255 counts as 1, as in `graspdb track`.
double distance(const Neighbor& neighbour) {
  return std::sqrt(static_cast<double>(neighbour.squared_distance)) / 255;
}

const std::string& grasp_name(const Database& database, std::size_t row) {
  return std::ranges::find(database.info().grasps, database.grasp(row), &GraspEntry::id)->name;
}

void print_json(const Database& database, const Query& query,
                const std::vector<Neighbor>& neighbours) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Neighbor& neighbour : neighbours) {
    const std::size_t row = neighbour.row;
    list.push_back({{"row", row},
                    {"distance", distance(neighbour)},
                    {"grasp", {{"id", database.grasp(row)}, {"name", grasp_name(database, row)}}},
                    {"step", database.step(row)},
                    {"view", database.view(row)},
                    {"hand", database.info().hands[database.hand(row)].name},
                    {"variant", database.info().variants[database.variant(row)]}});
  }
  const Box& box = query.box;
  const nlohmann::ordered_json answer{{"box", {box.x, box.y, box.width, box.height}},
                                      {"neighbours", std::move(list)}};
  fmt::print("{}\n", answer.dump(1));
}

void print_text(const Database& database, const std::vector<Neighbor>& neighbours) {
  fmt::print("distance      row  grasp                           step  view\n");
  for (const Neighbor& neighbour : neighbours) {
    const std::size_t row = neighbour.row;
    fmt::print("{:8.3f} {:8}  {:5} {:<25} {:4} {:5}  {}, {}\n", distance(neighbour), row,
               database.grasp(row), grasp_name(database, row), database.step(row),
               database.view(row), database.info().hands[database.hand(row)].name,
               database.info().variants[database.variant(row)]);
  }
}

void draw(const Options& options, const Database& database, const Query& query,
          const std::vector<Neighbor>& neighbours) {
  std::vector<std::size_t> rows;
  for (const Neighbor& neighbour : neighbours) rows.push_back(neighbour.row);
  const std::string title = std::filesystem::path(options.image).filename().string() + " in " +
                            database.path().filename().string();
  write_png(options.out, draw_row_sheet(database, rows, title, hand_picture(query)));
}

void run(const Options& options) {
  const Database database = Database::open(options.database);
  const Query query = read_query(options);
  const Descriptor hog = describe(to_gray(query.picture), query.hand,
                                  hog_from_name(database.info().hog, options.database));
  const auto neighbours = open_search(database, options.search)->nearest(hog, options.count);
  if (!options.out.empty()) draw(options, database, query, neighbours);
  if (options.json) {
    print_json(database, query, neighbours);
  } else {
    print_text(database, neighbours);
  }
}

}  // namespace

void add_query(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("query", "List the rows nearest to the hand in one picture");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("IMAGE", options->image, "A picture with a right hand")->required();
  verb->add_option("--mask", options->mask,
                   "A picture of the same size, bright where the hand is [skin colour]");
  verb->add_option("-k,--neighbours", options->count, "How many rows")->check(CLI::Range(1, 1000));
  verb->add_option("--search", options->search, "How neighbours are found")
      ->check(CLI::IsMember(search_names()));
  verb->add_option("--out", options->out,
                   "Also draw the hand beside its nearest rows to this PNG; needs the hand and "
                   "grasp files that the database was built from");
  verb->add_flag("--json", options->json, "As JSON");
  verb->footer("Example: graspdb query hands.graspdb photo.jpg -k 8 --out near.png");
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
