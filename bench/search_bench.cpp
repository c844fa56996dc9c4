// SPDX-License-Identifier: MIT
// Time of one search of the 50 nearest among 106,920 rows, on one core, and the recall it reaches.
#include <benchmark/benchmark.h>

#include "graspdb/search.h"
#include "support/hog_like.h"
#include "support/temporary_directory.h"
#include "support/toy_database.h"

namespace graspdb {
namespace {

constexpr std::size_t kRows = 106'920;
constexpr int kNeighbors = 50;

struct World {
  testing::TemporaryDirectory directory;
  testing::HogLike hogs{0};
  Database database = testing::database_of(directory / "bench.graspdb", hogs.descriptors(0, kRows));
  std::vector<Descriptor> queries = hogs.descriptors(kRows, 200);
};

const World& world() {
  static const World world;
  return world;
}

void search(benchmark::State& state, const Search& search) {
  const std::vector<Descriptor>& queries = world().queries;
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.nearest(queries[next++ % queries.size()], kNeighbors));
  }
}

void exact(benchmark::State& state) {
  search(state, *make_exact_search(world().database));
}
BENCHMARK(exact)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace graspdb

BENCHMARK_MAIN();
