// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "console.h"
#include "graspdb/metrics.h"
#include "graspdb/search.h"
#include "held_out_queries.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

Spread time_ms(const Search& search, const std::vector<Descriptor>& queries, int k) {
  std::vector<double> ms;
  for (const Descriptor& query : queries) {
    const auto begin = std::chrono::steady_clock::now();
    search.nearest(query, k);
    ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                     .count());
  }
  return spread(std::move(ms));
}

}  // namespace

void add_bench(CLI::App& app) {
  struct Options {
    std::string database;
    int queries = 200, k = 20;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      app.add_subcommand("bench", "Time the searches and measure their recall on held-out views");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--queries", options->queries, "Views between the database's own")
      ->check(CLI::Range(1, 100000));
  verb->add_option("-k", options->k, "Neighbours")->check(CLI::Range(1, 1000));
  verb->add_flag("--json", options->json, "As JSON");
  verb->callback([options] {
    const Database database = Database::open(options->database);
    const auto queries = held_out_queries(database, options->queries);
    const auto exact = open_search(database, "exact");
    nlohmann::json lines = nlohmann::json::array();
    for (const std::string method : {"exact", "scan", "lsh"}) {
      const auto opened = method == "exact" ? nullptr : open_search(database, method);
      const Search& search = opened ? *opened : *exact;
      const double found = recall(search, *exact, queries, options->k);
      const Spread ms = time_ms(search, queries, options->k);
      lines.push_back({{"search", method},
                       {"k", options->k},
                       {"median_ms", ms.median},
                       {"p90_ms", ms.p90},
                       {"recall", found}});
      if (!options->json) {
        fmt::print("{:6} k {}  median {:.3f} ms  p90 {:.3f} ms  recall {:.4f}\n", method,
                   options->k, ms.median, ms.p90, found);
      }
    }
    if (options->json)
      fmt::print("{}\n", nlohmann::json{{"rows", database.rows()}, {"searches", lines}}.dump(1));
  });
}

}  // namespace graspdb::cli
