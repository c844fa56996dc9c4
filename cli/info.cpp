// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "checks.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/database/database.h"
#include "graspdb/pictures/row_sheet.h"
#include "graspdb/renderer/image_io.h"
#include "row_selection.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

// What a database tells as JSON of its own, under that name.
nlohmann::json told(const Database& database, const std::string& text, const char* key) {
  return parse_strict_json(text, database.path().string(), key);
}

// Nothing of a file from before databases had one.
nlohmann::json card_of(const Database& database) {
  const std::string& card = database.info().data_card;
  return card.empty() ? nlohmann::json() : told(database, card, "data_card");
}

// What a reader must know before anything else; --json has the rest.
void print_card(const nlohmann::json& card) {
  if (!card.is_object()) return;
  for (const char* key : {"row", "people", "use", "licence"}) {
    if (card.contains(key) && card[key].is_string())
      fmt::print("{:<8} {}\n", key, card[key].get<std::string>());
  }
}

// Null where rows have HOGs alone.
nlohmann::json descriptor_json(const DatabaseInfo& info) {
  if (info.embedding_bytes == 0) return nullptr;
  return {
      {"name", info.descriptor}, {"bytes", info.embedding_bytes}, {"weights_hash", info.weights}};
}

nlohmann::json to_json(const Database& database) {
  const DatabaseInfo& info = database.info();
  nlohmann::json grasps = nlohmann::json::array();
  for (const GraspEntry& grasp : info.grasps)
    grasps.push_back({{"id", grasp.id}, {"name", grasp.name}});
  nlohmann::json hands = nlohmann::json::array();
  for (const HandEntry& hand : info.hands) hands.push_back(hand.name);
  return {{"rows", database.rows()},
          {"grasps", grasps},
          {"hands", hands},
          {"variants", info.variants},
          {"steps", info.steps},
          {"views", info.views},
          {"view_rule", info.view_rule},
          {"hog", info.hog},
          {"descriptor", descriptor_json(info)},
          {"config", told(database, info.config, "config")},
          {"tool", info.tool},
          {"data_card", card_of(database)},
          {"content_hash", database.content_hash()}};
}

void print(const Database& database) {
  const DatabaseInfo& info = database.info();
  fmt::print("{}: {} rows = {} hands x {} variants x {} grasps x {} steps x {} views\n",
             database.path().string(), database.rows(), info.hands.size(), info.variants.size(),
             info.grasps.size(), info.steps, info.views);
  for (const HandEntry& hand : info.hands) {
    fmt::print("hand     {} ({:.0f} mm)\n", hand.name, 1000 * hand_length(hand.skeleton));
  }
  for (const std::string& variant : info.variants) fmt::print("variant  {}\n", variant);
  for (const GraspEntry& grasp : info.grasps)
    fmt::print("grasp    {:3} {}\n", grasp.id, grasp.name);
  fmt::print("views    {}\nhog      {}\n", info.view_rule, info.hog);
  if (info.embedding_bytes > 0) {
    fmt::print("learned  {}, {} bytes, weights {}\n", info.descriptor, info.embedding_bytes,
               info.weights);
  }
  fmt::print("config   {}\ntool     {}\ncontent  {}\n", info.config, info.tool,
             database.content_hash());
  print_card(card_of(database));
}

struct InfoArguments {
  std::string file, sheet;
  bool json = false;
  int rows = 60;
};

void run_info(const InfoArguments& options) {
  const Database database = Database::open(options.file);
  if (!options.sheet.empty()) {
    const auto rows = spread_rows(database.rows(), static_cast<std::size_t>(options.rows));
    const std::string title = fmt::format("{}: {} of {} rows", database.path().filename().string(),
                                          rows.size(), database.rows());
    write_png(options.sheet, draw_row_sheet(database, rows, title));
  }
  if (options.json) {
    fmt::print("{}\n", to_json(database).dump(1));
  } else {
    print(database);
  }
}

void add_verify(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  CLI::App* verify =
      app.add_subcommand("verify", "Check every byte of a database against its checksums");
  verify->add_option("DB", *file, "The database")->required();
  verify->callback([file] {
    verify_database(*file);
    fmt::print("{}: every checksum holds\n", *file);
  });
}

}  // namespace

void add_info(CLI::App& app) {
  auto options = std::make_shared<InfoArguments>();
  CLI::App* info = app.add_subcommand("info", "Say what a database holds");
  info->add_option("DB", options->file, "The database")->required();
  info->add_flag("--json", options->json, "As JSON");
  CLI::Option* sheet = info->add_option("--sheet", options->sheet,
                                        "Also draw rows, evenly chosen, to this PNG; needs the "
                                        "hand and grasp files that the database was built from")
                           ->check(output_file({".png"}));
  info->add_option("--rows", options->rows, "How many the sheet shows")
      ->check(range(1, 1000))
      ->needs(sheet);
  info->callback([options] { run_info(*options); });
  add_verify(app);
}

}  // namespace graspdb::cli
