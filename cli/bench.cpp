// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "checks.h"
#include "console.h"
#include "graspdb/bench/held_out_queries.h"
#include "graspdb/bench/tracker_bench.h"
#include "graspdb/core/stopwatch.h"
#include "graspdb/database/search.h"
#include "graspdb/evaluation/metrics.h"
#include "verbs.h"

namespace graspdb::cli {
namespace {

using nlohmann::json;

struct BenchArguments {
  std::string database, video;
  int queries = 200, k = 20, frames = 500;
  bool json = false;
};

Spread time_ms(const Search& search, const std::vector<DescriptorBytes>& queries, int k) {
  std::vector<double> ms;
  for (const DescriptorBytes& query : queries) {
    const Stopwatch watch;
    search.nearest(query, k);
    ms.push_back(watch.ms());
  }
  return spread(std::move(ms));
}

json bench_searches(const Database& database, const BenchArguments& options) {
  const auto queries = held_out_queries(database, options.queries);
  const auto exact = open_search(database, "exact");
  json lines = json::array();
  for (const std::string& method : search_names()) {
    const auto opened = method == "exact" ? nullptr : open_search(database, method);
    const Search& search = opened ? *opened : *exact;
    const double found = recall(search, *exact, queries, options.k);
    const Spread ms = time_ms(search, queries, options.k);
    lines.push_back({{"search", method},
                     {"k", options.k},
                     {"median_ms", ms.median},
                     {"p90_ms", ms.p90},
                     {"recall", found}});
    if (options.json) continue;
    fmt::print("{:6} k {}  median {:.3f} ms  p90 {:.3f} ms  recall {:.4f}\n", method, options.k,
               ms.median, ms.p90, found);
  }
  return lines;
}

void run(const BenchArguments& options) {
  const Database database = Database::open(options.database);
  const TrackerBench tracker = bench_tracker(database, options.video, options.frames,
                                             console_progress("rendered", "frames"));
  if (!options.json) fmt::print("{}\n", bench_table(tracker));
  const json searches = bench_searches(database, options);
  if (!options.json) return;
  fmt::print(
      "{}\n",
      json{{"rows", database.rows()}, {"searches", searches}, {"tracker", bench_json(tracker)}}
          .dump(1));
}

}  // namespace

void add_bench(CLI::App& app) {
  auto options = std::make_shared<BenchArguments>();
  CLI::App* verb =
      app.add_subcommand("bench", "Time searches and tracker, and measure their recall and memory");
  verb->add_option("DB", options->database, "The database")->required();
  verb->add_option("--queries", options->queries, "Views between the database's own")
      ->check(range(1, 100000));
  verb->add_option("-k", options->k, "Neighbours")->check(range(1, 1000));
  verb->add_option("--video", options->video,
                   "What the tracker is shown, as for `track` [a rendered sequence]");
  verb->add_option("--frames", options->frames,
                   "Frames that are timed; a shorter video is shown again")
      ->check(range(1, 100000));
  verb->add_flag("--json", options->json, "As JSON");
  verb->callback([options] { run(*options); });
}

}  // namespace graspdb::cli
