// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "console.h"
#include "graspdb/metrics.h"
#include "graspdb/random.h"
#include "held_out_queries.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

struct SearchSpeed {
  std::string method;
  Spread ms;
  double recall = 0;  // of the exact k nearest
};

double share_found(const std::vector<Neighbor>& exact, const std::vector<Neighbor>& found) {
  std::size_t common = 0;
  for (const Neighbor& neighbour : exact) {
    common += std::find(found.begin(), found.end(), neighbour) != found.end() ? 1 : 0;
  }
  return static_cast<double>(common) / static_cast<double>(exact.size());
}

SearchSpeed measure(const std::string& method, const Search& search, const Search& exact,
                    const std::vector<Descriptor>& queries, int k) {
  SearchSpeed result{.method = method};
  std::vector<double> ms;
  for (const Descriptor& query : queries) {
    const auto begin = std::chrono::steady_clock::now();
    const auto found = search.nearest(query, k);
    ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                     .count());
    result.recall +=
        share_found(exact.nearest(query, k), found) / static_cast<double>(queries.size());
  }
  result.ms = spread(std::move(ms));
  return result;
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
      const auto search = open_search(database, method);
      const SearchSpeed speed = measure(method, *search, *exact, queries, options->k);
      lines.push_back({{"search", method},
                       {"k", options->k},
                       {"median_ms", speed.ms.median},
                       {"p90_ms", speed.ms.p90},
                       {"recall", speed.recall}});
      if (!options->json) {
        fmt::print("{:6} k {}  median {:.3f} ms  p90 {:.3f} ms  recall {:.4f}\n", method,
                   options->k, speed.ms.median, speed.ms.p90, speed.recall);
      }
    }
    if (options->json)
      fmt::print("{}\n", nlohmann::json{{"rows", database.rows()}, {"searches", lines}}.dump(1));
  });
}

}  // namespace graspdb::cli
