// SPDX-License-Identifier: MIT
// Time of one search of the 50 nearest among 106,920 rows, on one core, and the recall it reaches.
#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <vector>

#include "graspdb/core/parallel.h"
#include "graspdb/database/search.h"
#include "support/ball_hands.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

constexpr std::size_t kRows = 106'920;
constexpr int kNeighbors = 50;

std::vector<Descriptor> many(std::size_t count,
                             const std::function<Descriptor(std::size_t)>& make) {
  std::vector<Descriptor> all(count);
  parallel_for(count, 0, [&](std::size_t i) { all[i] = make(i); });
  return all;
}

struct World {
  testing::TemporaryDirectory directory;
  Database database =
      testing::database_of(directory / "bench.graspdb", many(kRows, testing::BallHands::row));
  std::vector<DescriptorBytes> queries =
      testing::bytes_of(many(200, [](std::size_t i) { return testing::BallHands::query(i, 33); }));
  std::unique_ptr<Search> oracle = make_exact_search(database);
};

const World& world() {
  static const World world;
  return world;
}

void measure(benchmark::State& state, const Search& search) {
  const std::vector<DescriptorBytes>& queries = world().queries;
  state.counters["recall"] = recall(search, *world().oracle, queries, kNeighbors);
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.nearest(queries[next++ % queries.size()], kNeighbors));
  }
}

void exact(benchmark::State& state) {
  measure(state, *world().oracle);
}
BENCHMARK(exact)->Unit(benchmark::kMicrosecond);

void scan(benchmark::State& state) {
  const ScanOptions options{.dimensions = static_cast<int>(state.range(0)),
                            .rerank = static_cast<int>(state.range(1))};
  measure(state, *make_scan_search(world().database, options));
}
BENCHMARK(scan)
    ->Unit(benchmark::kMicrosecond)
    ->ArgNames({"dimensions", "rerank"})
    ->Args({64, 400})
    ->Args({128, 200})

    ->Args({128, 400});

void lsh(benchmark::State& state) {
  const LshOptions options{.tables = static_cast<int>(state.range(0)),
                           .hashes = static_cast<int>(state.range(1)),
                           .width = static_cast<double>(state.range(2)),
                           .probes = static_cast<int>(state.range(3))};
  measure(state, *make_lsh_search(world().database, options));
}
BENCHMARK(lsh)
    ->Unit(benchmark::kMicrosecond)
    ->ArgNames({"tables", "hashes", "width", "probes"})
    ->Args({10, 16, 4, 50})
    ->Args({20, 18, 4, 20})
    ->Args({40, 16, 3, 30})
    ->Args({40, 24, 5, 8});

}  // namespace
}  // namespace graspdb

BENCHMARK_MAIN();
