// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "console.h"
#include "graspdb/database.h"
#include "graspdb/search.h"
#include "verbs.h"

namespace graspdb::cli {

void add_index(CLI::App& app) {
  struct Options {
    std::string database;
    std::string method = "lsh";
    LshOptions lsh;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("index", "Build a search index beside a database");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--method", options->method, "The kind of index")->check(CLI::IsMember({"lsh"}));
  verb->add_option("--tables", options->lsh.tables, "Hash tables")->check(CLI::Range(1, 1000));
  verb->add_option("--hashes", options->lsh.hashes, "Projections a table")
      ->check(CLI::Range(1, 32));
  verb->add_option("--width", options->lsh.width, "Cell width, in typical neighbour distances")
      ->check(CLI::Range(0.001, 1000.0));
  verb->add_option("--probes", options->lsh.probes, "Buckets looked up a table")
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--seed", options->lsh.seed, "Seed of the projections");
  verb->callback([options] {
    const Database database = Database::open(options->database);
    const auto file = index_file(database, options->method);
    save_lsh_index(file, database, options->lsh);
    fmt::print("{}\n", file.string());
  });
}

}  // namespace graspdb::cli
