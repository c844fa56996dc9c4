// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <thread>

#include "graspdb/bench/tracker_bench.h"
#include "graspdb/core/append.h"
#include "graspdb/evaluation/eval_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

double megabytes(double bytes) {
  return bytes / 1e6;
}

// What reading needs beyond what this process held before: the program, and the frames that wait.
double peak_mb(const SearchBench& bench) {
  return megabytes(bench.after.peak - bench.before.own - bench.before.files);
}

std::string search_table(const SearchBench& bench) {
  std::string out;
  append(out, "\n{:20} {:>8} {:>8} {:>8}\n", bench.search + ", ms per frame", "p50", "p95", "p99");
  for (std::size_t i = 0; i < kBenchStages.size(); ++i) {
    const Percentiles& ms = bench.ms[i];
    append(out, "  {:18} {:8.3f} {:8.3f} {:8.3f}\n", kBenchStages[i], ms.p50, ms.p95, ms.p99);
  }
  append(out, "  hand read in {:.0f} % of the frames, temporal model {}, {} neighbours\n",
         100 * bench.valid, temporal_name(bench.tracker.temporal), bench.tracker.neighbors);
  append(out, "  opening: database {:.2f} ms, search {:.0f} ms\n", bench.open_database_ms,
         bench.open_search_ms);
  append(out, "  resident: {:.0f} MB at most beyond the {:.0f} MB of before\n", peak_mb(bench),
         megabytes(bench.before.own + bench.before.files));
  return out;
}

json search_json(const SearchBench& bench) {
  json line = {{"search", bench.search},
               {"temporal", temporal_name(bench.tracker.temporal)},
               {"options", options_json(bench.tracker)},
               {"open_database_ms", bench.open_database_ms},
               {"open_search_ms", bench.open_search_ms},
               {"valid", bench.valid},
               {"before_mb", megabytes(bench.before.own + bench.before.files)},
               {"peak_mb", peak_mb(bench)},
               {"own_mb", megabytes(bench.after.own - bench.before.own)},
               {"files_mb", megabytes(bench.after.files - bench.before.files)}};
  for (std::size_t i = 0; i < kBenchStages.size(); ++i) {
    const Percentiles& ms = bench.ms[i];
    line["ms"][kBenchStages[i]] = {{"p50", ms.p50}, {"p95", ms.p95}, {"p99", ms.p99}};
  }
  return line;
}

}  // namespace

std::string bench_table(const TrackerBench& bench) {
  std::string out = fmt::format(
      "tracker: {}, {} x {}; {} frames timed after a warm-up; one thread\n"
      "load of the machine {:.2f} on {} processors\n",
      bench.video, bench.width, bench.height, bench.frames, bench.load,
      std::thread::hardware_concurrency());
  for (const SearchBench& search : bench.searches) out += search_table(search);
  return out;
}

json bench_json(const TrackerBench& bench) {
  json searches = json::array();
  for (const SearchBench& search : bench.searches) searches.push_back(search_json(search));
  return {{"video", bench.video},   {"width_px", bench.width}, {"height_px", bench.height},
          {"frames", bench.frames}, {"load", bench.load},      {"trackers", searches}};
}

}  // namespace graspdb
