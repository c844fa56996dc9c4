// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "checks.h"
#include "finder_options.h"
#include "graspdb/core/error.h"
#include "graspdb/pictures/row_sheet.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/tracker/hand_reader.h"
#include "graspdb/video/frame_source.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct QueryArguments {
  std::string database, image, mask, search = kDefaultSearch, out;
  FinderSettings finder;
  int count = 20;
  bool json = false;
};

struct Query {
  Picture picture;
  Estimate seen;
};

// The square around the hand; what is not hand is pale.
ColorImage hand_picture(const Query& query) {
  const Box& box = query.seen.box;
  const Mask& hand = query.seen.hand;
  const int side = std::max(box.width, box.height) * 11 / 10;
  const int left = box.x + (box.width - side) / 2, top = box.y + (box.height - side) / 2;
  ColorImage square(side, side, {250, 250, 250});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int u = left + x, v = top + y;
      if (u < 0 || v < 0 || u >= hand.width() || v >= hand.height()) continue;
      Bgr& pixel = square.at(x, y) = query.picture.color.at(u, v);
      if (hand.at(u, v) != 0) continue;
      for (std::uint8_t& channel : pixel) channel = static_cast<std::uint8_t>(190 + channel / 4);
    }
  }
  return square;
}

void print_json(const Database& database, const Query& query,
                const std::vector<Neighbor>& neighbors) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Neighbor& neighbor : neighbors) {
    const std::size_t row = neighbor.row;
    const int grasp = database.grasp(row);
    list.push_back({{"row", row},
                    {"distance", descriptor_distance(neighbor)},
                    {"grasp", {{"id", grasp}, {"name", grasp_name(database.info(), grasp)}}},
                    {"step", database.step(row)},
                    {"view", database.view(row)},
                    {"hand", database.info().hands[database.hand(row)].name},
                    {"variant", database.info().variants[database.variant(row)]}});
  }
  const Box& box = query.seen.box;
  nlohmann::ordered_json answer{{"box", {box.x, box.y, box.width, box.height}},
                                {"neighbours", std::move(list)}};
  if (!query.picture.notes.empty()) answer["notes"] = query.picture.notes;
  fmt::print("{}\n", answer.dump(1));
}

void print_text(const Database& database, const std::vector<Neighbor>& neighbors) {
  fmt::print("distance      row  grasp                           step  view\n");
  for (const Neighbor& neighbor : neighbors) {
    const std::size_t row = neighbor.row;
    fmt::print("{:8.3f} {:8}  {:5} {:<25} {:4} {:5}  {}, {}\n", descriptor_distance(neighbor), row,
               database.grasp(row), grasp_name(database.info(), database.grasp(row)),
               database.step(row), database.view(row),
               database.info().hands[database.hand(row)].name,
               database.info().variants[database.variant(row)]);
  }
}

void draw(const QueryArguments& options, const Database& database, const Query& query,
          const std::vector<Neighbor>& neighbors) {
  std::vector<std::size_t> rows;
  for (const Neighbor& neighbor : neighbors) rows.push_back(neighbor.row);
  const std::string title = std::filesystem::path(options.image).filename().string() + " in " +
                            database.path().filename().string();
  write_png(options.out, draw_row_sheet(database, rows, title, hand_picture(query)));
}

Query read_query(const QueryArguments& options, HandReader& reader) {
  Query query{.picture = read_picture(options.image)};
  for (const std::string& note : query.picture.notes)
    fmt::print(stderr, "{}: {}\n", options.image, note);
  const ColorImage& color = query.picture.color;
  const Intrinsics camera = guess_camera(color.width(), color.height());
  query.seen = options.mask.empty() ? reader.read(color, camera)
                                    : reader.read(color, read_mask(options.mask, color), camera);
  if (query.seen.box.width > 0) return query;
  throw Error({.file = options.image,
               .expected = "a hand",
               .found = query.seen.colorless ? "a picture without colour to find one by (--mask)"
                                             : "none"});
}

void run(const QueryArguments& options) {
  const Database database = Database::open(options.database);
  HandReader reader(database, {.finder = options.finder.options(options.mask.empty())},
                    options.search);
  const Query query = read_query(options, reader);
  const auto neighbors = reader.search().nearest(query.seen.descriptor, options.count);
  if (!options.out.empty()) draw(options, database, query, neighbors);
  if (options.json) {
    print_json(database, query, neighbors);
  } else {
    print_text(database, neighbors);
  }
}

}  // namespace

void add_query(CLI::App& app) {
  auto options = std::make_shared<QueryArguments>();
  CLI::App* verb = app.add_subcommand("query", "List the rows nearest to the hand in one picture");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("IMAGE", options->image, "A picture with a right hand")->required();
  verb->add_option("--mask", options->mask,
                   "A picture of the same size, bright where the hand is [what --finder finds]");
  add_finder_option(*verb, options->finder);
  verb->add_option("-k,--neighbours", options->count, "How many rows")->check(range(1, 1000));
  verb->add_option("--search", options->search, "How neighbours are found")
      ->check(one_of(search_names()));
  verb->add_option("--out", options->out,
                   "Also draw the hand beside its nearest rows to this PNG; needs the hand and "
                   "grasp files that the database was built from")
      ->check(output_file({".png"}));
  verb->add_flag("--json", options->json, "As JSON");
  verb->footer("Example: graspdb query hands.graspdb photo.jpg -k 8 --out near.png");
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
